package org.evoloop.console;

import java.util.concurrent.CountDownLatch;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;

/** A program with a console, for tests that need a whole process. */
final class ConsoleProgram {
    private ConsoleProgram() {}

    public static void main(String[] arguments) {
        LampConverter lamp = new LampConverter(LoopConfig.defaults("lamp", new SystemClock()));
        Console console = new Console(lamp.converter, System.in, System.out, System.err);
        console.addCommand(ConsoleCommand.of("jline", "says whether JLine is present", (words, out) -> {
            try {
                out.println(Class.forName("org.jline.reader.LineReader").getSimpleName());
            } catch (ClassNotFoundException none) {
                out.println("no JLine");
            }
        }));
        console.addCommand(ConsoleCommand.of("wait", "waits for an interrupt", (words, out) -> {
            // Not its result, which is shown only when it ends.
            System.out.println("waiting");
            new CountDownLatch(1).await();
        }));
        int status = console.run();
        System.out.println("ended, converter " + lamp.converter.status().loop());
        System.exit(status);
    }
}
