package org.evoloop.converter.attachment;

import java.util.Objects;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * The access to what a class of {@code org.evoloop.converter} keeps from its users, for the packages behind it. The class
 * gives it when it is initialized, which is before there is an object of it.
 *
 * <p>Threading: thread-safe.
 *
 * @param <O> a superclass of that class
 * @param <A> the access to one object of it
 */
public final class Friend<O, A> {
    private volatile @Nullable Function<O, A> access;

    Friend() {}

    /** Called once, by the class itself. */
    public void give(Function<O, A> given) {
        access = given;
    }

    /** The access to {@code owner}, which is an object of that class. */
    public A of(O owner) {
        return Objects.requireNonNull(access).apply(owner);
    }
}
