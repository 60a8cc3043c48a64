package org.evoloop.function;

import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A new function that is a MAPE-K loop of its own, made of the same superclasses as the converter (paper, section V.B):
 * it is independent of the converter and of other functions.
 *
 * <p>Each visit gets a loop of its own, which is closed when the state is left.
 *
 * @param <O> an occurrence of that loop
 * @param <A> an analysis of that loop
 * @param <P> a plan of that loop
 */
public abstract class ControlLoopFunction<O, A, P> implements NewFunction {
    private static final Logger LOG = LoggerFactory.getLogger(ControlLoopFunction.class);

    /** For subclasses. */
    protected ControlLoopFunction() {}

    /** Adds the components for {@code visit} to {@code loop}, and with {@link Visit#onEnd} what must be cleaned up. */
    protected abstract void assemble(MapeLoop<O, A, P> loop, Visit visit) throws Exception;

    /**
     * A component of the loop has failed; the loop goes on. Called on the thread that calls the component, after it was logged.
     *
     * @param cause what it threw
     */
    protected void failed(Visit visit, Throwable cause) {}

    /** The loop's options; without threads if the converter has none. */
    protected LoopConfig config(Visit visit) {
        LoopConfig config = LoopConfig.defaults(visit.state().name(), visit.clock());
        return visit.threads() ? config : config.withoutThreads();
    }

    @Override
    public final void run(Visit visit) throws Exception {
        MapeLoop<O, A, P> loop = new MapeLoop<>(config(visit), new Listener(visit));
        assemble(loop, visit);
        visit.onEnd(loop::close);
        try {
            loop.buildAndStart();
        } catch (IllegalStateException closed) {
            // The state was left meanwhile, which has closed the loop.
            if (visit.isActive()) {
                throw closed;
            }
        }
    }

    private final class Listener implements LoopListener<O> {
        private final Visit visit;

        Listener(Visit visit) {
            this.visit = visit;
        }

        @Override
        public void failed(Failure<O> failure) {
            LOG.warn("{}: {}", visit.state(), failure, failure.cause());
            ControlLoopFunction.this.failed(visit, failure.cause());
        }

        @Override
        public void dropped(O occurrence, boolean first) {
            if (first) {
                LOG.debug("{}: its loop is slower than what it monitors", visit.state());
            }
        }
    }
}
