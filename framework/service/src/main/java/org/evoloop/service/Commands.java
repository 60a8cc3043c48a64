package org.evoloop.service;

import java.io.PrintStream;
import org.evoloop.console.Console;

/** The commands behind a control socket. */
interface Commands {
    /** See {@link Console#performAndWait}. */
    int perform(String line, PrintStream results, PrintStream errors) throws InterruptedException;

    /** Whether the program is about to end. */
    boolean isEnding();

    /** The commands of a console. */
    static Commands of(Console console) {
        return new Commands() {
            @Override
            public int perform(String line, PrintStream results, PrintStream errors) throws InterruptedException {
                return console.performAndWait(line, results, errors);
            }

            @Override
            public boolean isEnding() {
                return console.isEnding();
            }
        };
    }
}
