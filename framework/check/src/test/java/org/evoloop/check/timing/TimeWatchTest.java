package org.evoloop.check.timing;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.evoloop.PaperModels;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Sentry;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** Time properties on handwritten sequences of events. */
class TimeWatchTest {
    private static final ModelPair ROBOT = PaperModels.cleaningRobot();
    private static final long SECOND = 1_000_000_000;
    private static final Configuration ON = new Configuration(new State("On"), new State("On"));
    private static final Configuration MOVE = ON.withEvolved(new State("Move"));
    private static final Event SPOT = new Event("Spot");

    private static TimeWatch watch(String... lines) {
        TimeRules rules =
                PropertyFile.parse("robot.txt", String.join("\n", lines), ROBOT).time();
        return new TimeWatch(rules, ROBOT, ON, 0);
    }

    @Test
    void itIsWokenWhenTheNextTimeRunsOut() {
        TimeWatch watch = watch("Move never longer than 10 s", "after event Spot, function Move within 3 s");
        assertThat(watch.dueNanos()).isEqualTo(Sentry.NEVER);

        watch.comes(SPOT, ON, SECOND);
        assertThat(watch.dueNanos()).isEqualTo(4 * SECOND + 1);
        watch.moved(MOVE, 2 * SECOND);
        assertThat(watch.dueNanos()).isEqualTo(12 * SECOND + 1);
        watch.passed(12 * SECOND);
        assertThat(watch.poll()).isNull();
        watch.passed(12 * SECOND + 1);
        assertThat(watch.poll()).isEqualTo(new Sentry.Violation("Move never longer than 10 s", null));
        assertThat(watch.poll()).isNull();
        assertThat(watch.dueNanos()).isEqualTo(Sentry.NEVER);
    }

    @Test
    void whatWasObservedBeforeMayBeReportedAfter() {
        TimeWatch watch = watch("event Spot at most 1 times in 1 s");
        watch.comes(SPOT, ON, 5 * SECOND);
        watch.comes(SPOT, ON, 4 * SECOND);

        assertThat(watch.poll()).isNotNull();
    }

    @Test
    void anEventAllocatesNothing() {
        TimeWatch watch = watch(
                "Move never longer than 10 s",
                "Move never shorter than 1 ms",
                "after event Spot, function Move within 3 s",
                "Move only after 1 ms of On",
                "event Spot at most 3 times in 1 ms");
        Event unknown = new Event("Dance");
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long now = 0;
        long before = 0;
        boolean due = true;
        for (int time = 0; time < 20_000; time++) {
            if (time == 10_000) {
                before = threads.getCurrentThreadAllocatedBytes();
            }
            now += SECOND;
            watch.comes(SPOT, ON, now);
            watch.comes(unknown, ON, now);
            watch.moved(MOVE, now + 2);
            watch.passed(now + SECOND / 2);
            watch.moved(ON, now + SECOND / 2);
            due &= watch.dueNanos() == Sentry.NEVER;
        }
        long each = (threads.getCurrentThreadAllocatedBytes() - before) / 10_000;
        assertThat(due).isTrue();
        assertThat(watch.poll()).isNull();
        assertThat(each).isZero();
    }
}
