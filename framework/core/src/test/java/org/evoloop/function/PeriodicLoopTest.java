package org.evoloop.function;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.function.visit.VisitLog.take;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.function.visit.FunctionRunner;
import org.evoloop.function.visit.VisitLog;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A thermostat in four lambdas. */
@Timeout(60)
class PeriodicLoopTest {
    private static final Duration PERIOD = Duration.ofSeconds(10);

    private final BlockingQueue<Boolean> heater = new LinkedBlockingQueue<>();
    private volatile double celsius = 19;

    private double read() throws IOException {
        if (celsius < -273) {
            throw new IOException("no thermometer");
        }
        return celsius;
    }

    private final NewFunction heating =
            ControlLoopFunction.every(PERIOD, this::read, now -> 21 - now, gap -> gap > 0.5, heater::add);

    @Test
    void withoutThreadsItLooksAtOnceAndOnceAPeriod() {
        VisitLog log = new VisitLog(false);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(2));
        runner.begin(log.visit());
        runner.run(heating);
        log.clock.advance(Duration.ZERO);
        assertThat(heater).containsExactly(true);
        celsius = 22;
        log.clock.advance(PERIOD.minusNanos(1));
        assertThat(heater).hasSize(1);
        log.clock.advance(Duration.ofNanos(1));
        assertThat(heater).containsExactly(true, false);

        runner.end();
        log.clock.advance(Duration.ofMinutes(1));
        assertThat(heater).hasSize(2);
        assertThat(log.clock.pendingTasks()).isZero();
    }

    @Test
    void withThreadsToo() throws InterruptedException {
        VisitLog log = new VisitLog(true);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(2));
        runner.begin(log.visit());
        runner.run(heating);
        assertThat(take(heater)).isTrue();
        celsius = 22;
        while (heater.isEmpty()) {
            log.clock.advance(Duration.ofSeconds(1));
            Thread.onSpinWait();
        }
        assertThat(take(heater)).isFalse();
        runner.end();
        assertThat(log.failures).isEmpty();
    }

    @Test
    void aSensorThatFailsOnceDoesNotEndIt() {
        VisitLog log = new VisitLog(false);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(2));
        celsius = -300;
        runner.begin(log.visit());
        runner.run(heating);
        log.clock.advance(PERIOD);
        assertThat(heater).isEmpty();
        celsius = 19;
        log.clock.advance(PERIOD);
        assertThat(heater).containsExactly(true);
        runner.end();
    }

    @Test
    void aPeriodOfNothingIsRefused() {
        assertThatThrownBy(() -> ControlLoopFunction.every(
                        Duration.ZERO, this::read, now -> 21 - now, gap -> gap > 0.5, heater::add))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("the period is zero");
    }
}
