package org.evoloop.function;

import java.time.Duration;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
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
 * @since 0.1
 */
public abstract class ControlLoopFunction<O, A, P> implements NewFunction {
    private static final Logger LOG = LoggerFactory.getLogger(ControlLoopFunction.class);

    /** For subclasses. */
    protected ControlLoopFunction() {}

    /**
     * Reads the value that a loop monitors.
     *
     * @param <O> an occurrence of the loop
     */
    @FunctionalInterface
    public interface Sensor<O> {
        /**
         * Reads it now.
         *
         * @return null if there is no reading
         * @throws Exception any failure: it is reported, and the sensor is read again after a pause
         */
        @Nullable
        O read() throws Exception;
    }

    /**
     * Analyzes or plans.
     *
     * @param <I> the input
     * @param <R> the result
     */
    @FunctionalInterface
    public interface Transformation<I, R> {
        /**
         * The result for {@code input}.
         *
         * @return null if there is nothing to do, which ends the cycle
         * @throws Exception any failure: it is reported, and this cycle ends here
         */
        @Nullable
        R apply(I input) throws Exception;
    }

    /**
     * Acts.
     *
     * @param <P> a plan of the loop
     */
    @FunctionalInterface
    public interface Effector<P> {
        /**
         * Carries {@code plan} out.
         *
         * @throws Exception any failure: it is reported, and this cycle ends here
         */
        void act(P plan) throws Exception;
    }

    /**
     * A small loop made of four functions: it reads the sensor when the state is entered and then once a period. For
     * example, a thermostat:
     *
     * <pre>{@code
     * function("Heating", ControlLoopFunction.every(Duration.ofSeconds(10),
     *         () -> thermometer.celsius(), celsius -> 21 - celsius, gap -> gap > 0.5, on -> heater.set(on)));
     * }</pre>
     *
     * <p>Threading: each of the four is called on the thread of its component, {@code sensor} also while the others
     * work; in a converter without threads, all are called on the thread that advances the clock.
     *
     * @param period in the converter's time, more than 0
     * @param analyze interprets a reading
     * @param plan decides what to do about it
     * @throws IllegalArgumentException if {@code period} is zero, negative, or longer than {@link Clock#LONGEST}
     */
    public static <O, A, P> NewFunction every(
            Duration period,
            Sensor<? extends O> sensor,
            Transformation<? super O, ? extends A> analyze,
            Transformation<? super A, ? extends P> plan,
            Effector<? super P> effector) {
        return new PeriodicLoop<O, A, P>(period, sensor, analyze, plan, effector);
    }

    /** Adds the components for {@code visit} to {@code loop}, and registers clean-up with {@link Visit#onEnd}. */
    protected abstract void assemble(MapeLoop<O, A, P> loop, Visit visit) throws Exception;

    /**
     * A component of the loop has failed; the loop continues. Called on the thread that calls the component, after it
     * was logged.
     *
     * @param cause what it threw
     */
    protected void failed(Visit visit, Throwable cause) {}

    /** The loop's options; by default without threads if the converter has none. */
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
            // The state was left meanwhile, which closed the loop.
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
