package org.evoloop.benchmarks.running;

import java.util.List;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.loop.Plan;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.time.Clock;

/**
 * The framework's loop with analyze and plan components that pass their input on, so that only the loop is measured.
 */
public final class PlainLoop {
    private PlainLoop() {}

    /** The configuration of a loop with a thread per component, which is compared with bare rings of threads. */
    public static LoopConfig threads(String name, Clock clock) {
        return LoopConfig.defaults(name, clock).withThreading(ThreadingModel.THREAD_PER_COMPONENT);
    }

    /**
     * Builds such a loop, and opens it before a monitor is asked. If the loop refused an event, a monitor that waits
     * for its event to come round would wait forever.
     *
     * @param mayLose whether the measurement tolerates events that find the queue full
     */
    public static <T> MapeLoop<T, T, T> build(
            LoopConfig config, boolean mayLose, List<? extends Monitor<T>> monitors, Execute<T> execute) {
        MapeLoop<T, T, T> loop = new MapeLoop<>(config, new Listener<>(mayLose));
        monitors.forEach(loop::addMonitor);
        loop.addAnalyze(new SameAnalysis<>());
        loop.addPlan(new SamePlan<>());
        loop.addExecute(execute);
        loop.buildAndStart();
        return loop;
    }

    private static final class SameAnalysis<T> extends Analyze<T, T> {
        @Override
        protected T analyze(T given) {
            return given;
        }
    }

    private static final class SamePlan<T> extends Plan<T, T> {
        @Override
        protected T plan(T given) {
            return given;
        }
    }

    private static final class Listener<T> implements LoopListener<T> {
        private final boolean mayLose;

        Listener(boolean mayLose) {
            this.mayLose = mayLose;
        }

        @Override
        public void failed(Failure<T> failure) {
            throw new IllegalStateException(failure.toString());
        }

        @Override
        public void dropped(T occurrence, boolean first) {
            if (!mayLose) {
                throw new IllegalStateException("an occurrence was lost");
            }
        }
    }
}
