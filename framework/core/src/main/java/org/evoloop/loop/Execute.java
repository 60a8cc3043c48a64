package org.evoloop.loop;

/**
 * Superclass of the components that act. A loop may have several; its {@link Dispatch} decides which of them take a
 * plan, and in what order.
 *
 * <p>Threading: {@link #execute} is called as described in {@link Component}. It may wait, for instance until the
 * device is ready: occurrences queue up meanwhile. One that waits longer than the loop's step limit is interrupted.
 *
 * @param <P> a plan
 * @since 0.1
 */
public abstract non-sealed class Execute<P> extends Component {

    /** A component named after its class. */
    protected Execute() {
        this("");
    }

    /** @param name its name in the console, unique within a loop */
    protected Execute(String name) {
        super(name);
    }

    @Override
    public final Role role() {
        return Role.EXECUTE;
    }

    /**
     * Carries out {@code plan}; its effect has happened when this returns.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     * @throws Exception any failure: it is reported, and this occurrence ends here
     */
    protected abstract void execute(P plan) throws Exception;
}
