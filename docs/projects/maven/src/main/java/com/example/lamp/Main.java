package com.example.lamp;

import java.util.Scanner;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/** Each line of the standard input operates the switch. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        PushMonitor wallSwitch = new PushMonitor("WallSwitch");
        try (Clock clock = new SystemClock();
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
                Scanner lines = new Scanner(System.in)) {
            converter.addMonitor(wallSwitch);
            converter.addExecute(new LampExecute());
            converter.addKnowledge(new LampKnowledge());
            converter.build();
            converter.start();
            while (lines.hasNextLine()) {
                lines.nextLine();
                try {
                    wallSwitch.press("switch");
                } catch (IllegalStateException lost) {
                    System.err.println(lost.getMessage());
                }
            }
        }
    }
}
