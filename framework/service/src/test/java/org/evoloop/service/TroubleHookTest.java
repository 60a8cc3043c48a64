package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.function.Reading;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

/** With real commands, under a manual clock. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@EnabledOnOs(OS.LINUX)
class TroubleHookTest {
    @TempDir
    private Path folder;

    private final ManualClock clock = new ManualClock();
    private final Cable cable = new Cable();
    private final SystemEventConverter converter = LampProgram.converter(new PushMonitor("WallSwitch"), clock);
    private final Logger logger = (Logger) LoggerFactory.getLogger(TroubleHook.class);
    private final ListAppender<ILoggingEvent> log = new ListAppender<>();

    /** A connection whose condition the test sets. */
    private static final class Cable implements DeviceLink {
        private volatile boolean up = true;
        private volatile String error = "none";

        @Override
        public boolean isUp() {
            return up;
        }

        @Override
        public List<Reading> readings() {
            return List.of(Reading.of("error", error));
        }

        @Override
        public String describe() {
            return up ? "plugged in" : "the cable is out";
        }
    }

    @BeforeEach
    void listen() {
        converter.addLink(cable);
        log.start();
        logger.setLevel(Level.WARN);
        logger.setAdditive(false);
        logger.addAppender(log);
    }

    @AfterEach
    void close() {
        logger.detachAppender(log);
        logger.setAdditive(true);
        logger.setLevel(null);
        converter.close();
        clock.close();
    }

    private TroubleHook hook(String command, Duration limit) {
        TroubleHook hook = new TroubleHook(command, List.of(converter), clock, limit);
        hook.start();
        return hook;
    }

    private TroubleHook teller() {
        return hook(
                "echo \"$EVOLOOP_CONVERTER|$EVOLOOP_PART|$EVOLOOP_TROUBLE\" >> '" + folder.resolve("told") + "'",
                TroubleHook.LIMIT);
    }

    private List<String> told() throws IOException {
        Path file = folder.resolve("told");
        return Files.exists(file) ? Files.readAllLines(file) : List.of();
    }

    /** Lets time pass, in steps of one look, until that was told. */
    private void awaitTold(String... lines) {
        await().until(() -> {
            clock.advance(TroubleHook.LOOK);
            return told().equals(List.of(lines));
        });
    }

    @Test
    void eachNewTroubleIsToldOnceAndAgainWhenItHasComeBack() {
        try (TroubleHook hook = teller()) {
            cable.up = false;
            awaitTold("lamp|link|the cable is out");
            cable.up = true;
            cable.error = "a wheel\nhangs";
            awaitTold("lamp|link|the cable is out", "lamp|device|a wheel?hangs");
            // Whatever else was told is told before what comes after it.
            cable.up = false;
            clock.advance(TroubleHook.QUIET);
            awaitTold("lamp|link|the cable is out", "lamp|device|a wheel?hangs", "lamp|link|the cable is out");
        }
    }

    @Test
    void aCommandThatHangsIsKilledAndNobodyWaitsForIt() throws Exception {
        Path pid = folder.resolve("pid");
        try (TroubleHook hook = hook("echo $$ > '" + pid + "'; exec sleep 600", Duration.ofSeconds(2))) {
            cable.up = false;
            await().until(() -> {
                clock.advance(TroubleHook.LOOK);
                return Files.exists(pid) && !Files.readString(pid).isBlank();
            });
            assertThat(converter.status().troubles()).hasSize(1);
            long number = Long.parseLong(Files.readString(pid).strip());
            await().until(() -> ProcessHandle.of(number).isEmpty());
            await().until(() -> log.list.size() == 1);
            assertThat(log.list.get(0).getFormattedMessage())
                    .contains("for 'the cable is out'", "did not end within 2 s, so it was killed");
        }
    }

    @Test
    void aCommandThatFailsIsReportedOnceUntilItWorks() throws IOException {
        Path works = folder.resolve("works");
        String command = "echo \"$EVOLOOP_PART\" >> '" + folder.resolve("told") + "'; [ -e '" + works + "' ]";
        try (TroubleHook hook = hook(command, TroubleHook.LIMIT)) {
            cable.up = false;
            awaitTold("link");
            cable.up = true;
            cable.error = "a wheel hangs";
            awaitTold("link", "device");
            cable.error = "none";
            Files.createFile(works);
            cable.up = false;
            clock.advance(TroubleHook.QUIET);
            awaitTold("link", "device", "link");
            Files.delete(works);
            cable.up = true;
            cable.error = "a wheel hangs";
            clock.advance(TroubleHook.QUIET);
            awaitTold("link", "device", "link", "device");
            await().until(() -> log.list.size() == 2);
        }
        assertThat(log.list)
                .extracting(ILoggingEvent::getFormattedMessage)
                .allMatch(line -> line.contains("it ended with status 1"));
    }

    @Test
    void theCommandEndsWithTheProgram() throws Exception {
        Path pid = folder.resolve("pid");
        long number;
        try (TroubleHook hook = hook("echo $$ > '" + pid + "'; exec sleep 600", TroubleHook.LIMIT)) {
            cable.up = false;
            await().until(() -> {
                clock.advance(TroubleHook.LOOK);
                return Files.exists(pid) && !Files.readString(pid).isBlank();
            });
            number = Long.parseLong(Files.readString(pid).strip());
        }
        await().until(() -> ProcessHandle.of(number).isEmpty());
    }
}
