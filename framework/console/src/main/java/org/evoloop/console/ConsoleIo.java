package org.evoloop.console;

import java.io.IOException;
import java.io.PrintStream;
import java.time.Duration;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** Where a console's lines come from and go to. */
interface ConsoleIo extends AutoCloseable {

    /**
     * Waits for the next line.
     *
     * @return null at the end of the input, or if the user breaks off
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    @Nullable
    String readLine() throws IOException, InterruptedException;

    /** For results. */
    PrintStream out();

    /** For errors. */
    PrintStream err();

    /** Whether a person sits there. */
    boolean isTerminal();

    /**
     * Shows what {@code text} says, again and again in the same place, until a key is pressed.
     *
     * @throws InterruptedException if the thread is interrupted meanwhile
     * @throws IllegalStateException if this is no terminal
     */
    void watch(Supplier<String> text, Duration period) throws InterruptedException;

    /** Leaves everything as it was found. */
    @Override
    void close();
}
