package org.evoloop.service;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.evoloop.LightBulb;
import org.evoloop.RecordingExecute;
import org.evoloop.config.Settings;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/** The paper's light bulb as a program, with commands to close its converter and to hang. */
final class LampProgram {
    private LampProgram() {}

    public static void main(String[] arguments) throws Exception {
        Settings settings = ServiceOptions.OPTIONS.read(List.of(arguments), System.getenv());
        int status;
        try (Service service = Service.open(ServiceOptions.of(settings));
                Clock clock = new SystemClock()) {
            PushMonitor wallSwitch = new PushMonitor("WallSwitch");
            SystemEventConverter converter = converter(wallSwitch, clock);
            Console console = new Console(converter, System.in, System.out, System.err);
            console.addCommand(ConsoleCommand.press("switch", "", wallSwitch, words -> "switch"));
            console.addCommand(ConsoleCommand.of("close", "", (words, out) -> converter.close()));
            console.addCommand(
                    ConsoleCommand.of("hang", "", (words, out) -> clock.schedule(Duration.ZERO, LampProgram::hang)));
            status = service.run(console);
        } catch (IllegalArgumentException mistake) {
            System.err.println("error: " + mistake.getMessage());
            status = 2;
        }
        System.exit(status);
    }

    /** A built converter. */
    static SystemEventConverter converter(PushMonitor wallSwitch, Clock clock) {
        SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
        converter.addMonitor(wallSwitch);
        converter.addExecute(new RecordingExecute("Lamp", "switch"));
        converter.addKnowledge(new LightBulb());
        converter.build();
        return converter;
    }

    private static void hang() {
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }
}
