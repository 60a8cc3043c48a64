package org.evoloop.console;

import java.time.Duration;
import java.util.function.Supplier;

/** The reader of a command's output. */
interface Reader {
    /** Whether this is the program's terminal, which wraps lines to its own width. */
    boolean isAtTerminal();

    /**
     * As {@link ConsoleIo#watch}.
     *
     * @throws IllegalStateException if the reader has no terminal of this program
     */
    void watch(Supplier<String> text, Duration period) throws InterruptedException;
}
