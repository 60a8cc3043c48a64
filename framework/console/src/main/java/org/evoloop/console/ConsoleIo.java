package org.evoloop.console;

import java.io.IOException;
import java.io.PrintStream;
import java.time.Duration;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** The input and output of a console. */
interface ConsoleIo extends AutoCloseable {

    /**
     * Waits for the next line.
     *
     * @return null at the end of the input, or if the user ends it
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    @Nullable
    String readLine() throws IOException, InterruptedException;

    /** For results. */
    PrintStream out();

    /** For errors. */
    PrintStream err();

    /** Whether this is a terminal. */
    boolean isTerminal();

    /**
     * Shows {@code text}, updated in place, until a key is pressed.
     *
     * @throws InterruptedException if the thread is interrupted meanwhile
     * @throws IllegalStateException if this is not a terminal
     */
    void watch(Supplier<String> text, Duration period) throws InterruptedException;

    /** Restores the terminal. */
    @Override
    void close();
}
