package org.evoloop.function;

import java.time.Duration;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.loop.Plan;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/** A loop that reads its sensor once a period, written as four functions; see {@link ControlLoopFunction#every}. */
final class PeriodicLoop<O, A, P> extends ControlLoopFunction<O, A, P> {
    private final Duration period;
    private final Sensor<? extends O> sensor;
    private final Transformation<? super O, ? extends A> analyze;
    private final Transformation<? super A, ? extends P> plan;
    private final Effector<? super P> effector;

    PeriodicLoop(
            Duration period,
            Sensor<? extends O> sensor,
            Transformation<? super O, ? extends A> analyze,
            Transformation<? super A, ? extends P> plan,
            Effector<? super P> effector) {
        this.period = Clock.requireDelay(period);
        if (period.isZero()) {
            throw new IllegalArgumentException(
                    "the period is zero; a loop that never rests needs a monitor of its own");
        }
        this.sensor = sensor;
        this.analyze = analyze;
        this.plan = plan;
        this.effector = effector;
    }

    @Override
    protected void assemble(MapeLoop<O, A, P> loop, Visit visit) {
        Monitor<O> monitor = monitor(visit);
        loop.addMonitor(monitor);
        loop.addAnalyze(new Analyze<>("analyze") {
            @Override
            protected @Nullable A analyze(O occurrence) throws Exception {
                return analyze.apply(occurrence);
            }
        });
        loop.addPlan(new Plan<>("plan") {
            @Override
            protected @Nullable P plan(A analysis) throws Exception {
                return plan.apply(analysis);
            }
        });
        loop.addExecute(new Execute<>("execute") {
            @Override
            protected void execute(P planned) throws Exception {
                effector.act(planned);
            }
        });
        if (!visit.threads()) {
            stepAfter(Duration.ZERO, loop, monitor, visit);
        }
    }

    private Monitor<O> monitor(Visit visit) {
        return new Monitor<>("monitor") {
            private boolean looked;

            @Override
            protected @Nullable O getEvent() throws Exception {
                if (looked && visit.threads()) {
                    visit.sleep(period);
                }
                looked = true;
                return sensor.read();
            }
        };
    }

    /** Without threads, no one else takes the loop's steps. */
    private void stepAfter(Duration delay, MapeLoop<O, A, P> loop, Monitor<O> monitor, Visit visit) {
        visit.after(delay, () -> {
            try {
                loop.observe(monitor);
            } catch (InterruptedException stop) {
                Thread.currentThread().interrupt();
                return;
            }
            loop.step();
            stepAfter(period, loop, monitor, visit);
        });
    }
}
