package org.evoloop.console;

import java.time.Duration;
import java.util.function.Supplier;

/** Whoever has typed a command and reads what it prints. */
interface Reader {
    /** How long a line for people may be before it must be broken. */
    int width();

    /** As {@link ConsoleIo#watch}. @throws IllegalStateException if the reader has no terminal of this program */
    void watch(Supplier<String> text, Duration period) throws InterruptedException;
}
