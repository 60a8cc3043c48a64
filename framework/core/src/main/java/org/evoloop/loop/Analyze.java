package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * Superclass of the one component that finds out what an occurrence means.
 *
 * <p>Threading: {@link #analyze} is called as {@link Component} says, once an occurrence, never while an earlier
 * occurrence is still being planned or executed.
 *
 * @param <O> an occurrence
 * @param <A> what it means, what {@link Plan} takes
 * @since 0.1
 */
public abstract non-sealed class Analyze<O, A> extends Component {

    /** A component that is called like its class. */
    protected Analyze() {
        this("");
    }

    /** @param name what the console calls it, unique within a loop */
    protected Analyze(String name) {
        super(name);
    }

    @Override
    public final Role role() {
        return Role.ANALYZE;
    }

    /**
     * Finds out what {@code occurrence} means.
     *
     * @return the meaning, or null if there is nothing to do, which ends the cycle
     * @throws Exception any failure: it is reported, and this occurrence ends here
     */
    protected abstract @Nullable A analyze(O occurrence) throws Exception;
}
