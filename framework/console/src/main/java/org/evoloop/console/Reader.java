package org.evoloop.console;

import java.time.Duration;
import java.util.function.Supplier;

/** Whoever has typed a command and reads what it prints. */
interface Reader {
    /** Whether this is the terminal of the program, which breaks lines by itself, as narrow as it is. */
    boolean isAtTerminal();

    /** As {@link ConsoleIo#watch}. @throws IllegalStateException if the reader has no terminal of this program */
    void watch(Supplier<String> text, Duration period) throws InterruptedException;
}
