package org.evoloop.loop;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Chooses which {@link Execute} takes a plan next.
 *
 * <p>Threading: called on the threads of the loop, one at a time.
 *
 * @param <P> a plan
 * @since 0.1
 */
@FunctionalInterface
public interface Dispatch<P> {

    /**
     * The execute component that continues {@code plan}.
     *
     * @param executes all of them, in the order in which they were added, never empty
     * @param last the one that has just returned, null at first
     * @return null if the plan is carried out
     */
    @Nullable
    Execute<P> next(P plan, List<Execute<P>> executes, @Nullable Execute<P> last);

    /** Every execute component takes the whole plan, one after the other. */
    static <P> Dispatch<P> toEach() {
        return (plan, executes, last) -> {
            int next = last == null ? 0 : executes.indexOf(last) + 1;
            return next < executes.size() ? executes.get(next) : null;
        };
    }
}
