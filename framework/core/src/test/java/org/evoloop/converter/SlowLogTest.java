package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.AppenderBase;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import org.evoloop.converter.recording.FailureLog;
import org.evoloop.evolution.Outcome;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.slf4j.LoggerFactory;

/** A log that blocks, such as a pipe that is not read, delays neither events nor status. */
@Timeout(60)
class SlowLogTest {
    private final Logger logger = (Logger) LoggerFactory.getLogger(SystemEventConverter.class);
    private final CountDownLatch stuck = new CountDownLatch(1);
    private final CountDownLatch atLast = new CountDownLatch(1);
    private final AppenderBase<ILoggingEvent> slow = new AppenderBase<>() {
        @Override
        protected void append(ILoggingEvent event) {
            if (event.getFormattedMessage().contains("endSpott")) {
                stuck.countDown();
                LiveRobot.awaitDeaf(atLast);
            }
        }
    };

    @BeforeEach
    void listen() {
        slow.setContext(logger.getLoggerContext());
        slow.start();
        logger.setLevel(Level.WARN);
        logger.addAppender(slow);
    }

    @AfterEach
    void close() {
        atLast.countDown();
        logger.detachAppender(slow);
        logger.setLevel(null);
    }

    @Test
    void eventsAreConvertedAndStatusAnswersWhileAWarningIsWritten() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(visit -> {})) {
            robot.panel.ended("endSpott");
            LiveRobot.await(stuck);

            robot.press("Clean");

            assertThat(robot.awaitHistory(2).outcome()).isEqualTo(Outcome.HANDLED);
            assertThat(robot.converter.status().events().ignored()).isOne();
            atLast.countDown();
        }
    }

    @Test
    void whatTheLogHadNoRoomForIsCounted() throws InterruptedException {
        ManualClock clock = new ManualClock();
        FailureLog failures = new FailureLog(LoopConfig.defaults("slow", clock));
        try (LoggedLines log = new LoggedLines(logger.getName())) {
            failures.warnSoon("endSpott");
            LiveRobot.await(stuck);
            for (int other = 0; other < 110; other++) {
                clock.advance(Duration.ofSeconds(1));
                failures.warnSoon("warning " + other);
            }
            atLast.countDown();
            clock.advance(Duration.ofSeconds(10));
            assertThat(log.lines()).contains("10 more different warnings were left out; status counts the failures");
        }
    }
}
