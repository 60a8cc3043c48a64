package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * Superclass of the one component that decides what an occurrence means.
 *
 * <p>Threading: {@link #analyze} is called as described in {@link Component}, once for each occurrence, never while an
 * earlier occurrence is still being planned or executed.
 *
 * @param <O> an occurrence
 * @param <A> an analysis, the input of {@link Plan}
 * @since 0.1
 */
public abstract non-sealed class Analyze<O, A> extends Component {

    /** A component named after its class. */
    protected Analyze() {
        this("");
    }

    /** @param name its name in the console, unique within a loop */
    protected Analyze(String name) {
        super(name);
    }

    @Override
    public final Role role() {
        return Role.ANALYZE;
    }

    /**
     * Decides what {@code occurrence} means.
     *
     * @return the analysis, or null if there is nothing to do: see {@link #unlessDismissed}
     * @throws Exception any failure: it is reported, and this occurrence ends here
     */
    protected abstract @Nullable A analyze(O occurrence) throws Exception;

    /**
     * The analysis of {@code occurrence}, for which {@link #analyze} has returned null.
     *
     * @return null, the default, to dismiss the occurrence, which ends the cycle
     * @throws Exception as {@link #analyze}
     */
    protected @Nullable A unlessDismissed(O occurrence) throws Exception {
        return null;
    }
}
