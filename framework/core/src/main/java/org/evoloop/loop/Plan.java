package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * Superclass of the one component that decides what to do.
 *
 * <p>Threading: {@link #plan} is called as described in {@link Component}, once for each occurrence.
 *
 * @param <A> an analysis
 * @param <P> a plan, the input of {@link Execute}
 * @since 0.1
 */
public abstract non-sealed class Plan<A, P> extends Component {

    /** A component named after its class. */
    protected Plan() {
        this("");
    }

    /** @param name its name in the console, unique within a loop */
    protected Plan(String name) {
        super(name);
    }

    @Override
    public final Role role() {
        return Role.PLAN;
    }

    /**
     * Decides what to do about {@code analysis}.
     *
     * @return the plan, or null if there is nothing to do: see {@link #unlessDismissed}
     * @throws Exception any failure: it is reported, and this occurrence ends here
     */
    protected abstract @Nullable P plan(A analysis) throws Exception;

    /**
     * The plan for {@code analysis}, for which {@link #plan} has returned null.
     *
     * @return null, the default, to dismiss the occurrence, which ends the cycle
     * @throws Exception as {@link #plan}
     */
    protected @Nullable P unlessDismissed(A analysis) throws Exception {
        return null;
    }
}
