package org.evoloop.service;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.stream.Collectors;
import org.evoloop.time.Clock;

/** Redraws the output of a command on a terminal, in place. */
final class Watch {
    private static final String ERASE_ALL = "\u001b[2J";
    private static final String HOME = "\u001b[H";
    private static final String ERASE_REST_OF_LINE = "\u001b[K";
    private static final String ERASE_BELOW = "\u001b[J";

    /** The command to be shown. */
    interface Command {
        /**
         * Prints the output.
         *
         * @return the exit status
         */
        int print(PrintStream results) throws IOException;
    }

    private final PrintStream out;
    private final Clock clock;

    Watch(PrintStream out, Clock clock) {
        this.out = out;
        this.clock = clock;
    }

    /**
     * Repeats the command until it fails, and returns its exit status, or until the thread is interrupted, and returns
     * 0.
     *
     * @param period the time between two runs
     */
    int run(Command command, Duration period) throws IOException {
        out.print(ERASE_ALL);
        while (true) {
            ByteArrayOutputStream answer = new ByteArrayOutputStream();
            int status = command.print(new PrintStream(answer, true, StandardCharsets.UTF_8));
            if (status != 0) {
                return status;
            }
            String lines = answer.toString(StandardCharsets.UTF_8)
                    .lines()
                    .map(line -> line + ERASE_REST_OF_LINE + '\n')
                    .collect(Collectors.joining());
            // One write, so that the terminal never shows half of it.
            out.print(HOME + lines + "(Ctrl-C ends it)" + ERASE_REST_OF_LINE + '\n' + ERASE_BELOW);
            out.flush();
            try {
                clock.sleep(period);
            } catch (InterruptedException end) {
                return 0;
            }
        }
    }
}
