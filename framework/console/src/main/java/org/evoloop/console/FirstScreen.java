package org.evoloop.console;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopState;

/** The first screen of a terminal: the system's states, and what can be typed next. */
final class FirstScreen {
    private FirstScreen() {}

    /**
     * Prints it.
     *
     * @param converters the converters; the commands of the first have no name before them
     * @param offered the application's commands
     */
    static void show(List<SystemEventConverter> converters, List<ConsoleCommand> offered, PrintStream out) {
        converters.forEach(converter -> StatusText.brief(converter.status(), out));
        // A stopped converter is the one that needs attention.
        SystemEventConverter one = converters.stream()
                .filter(converter -> converter.status().loop() != LoopState.RUNNING)
                .findFirst()
                .orElse(converters.get(0));
        boolean first = one == converters.get(0);
        String next = NextStep.after(one, first ? "" : one.status().name() + " ", first ? offered : List.of());
        out.println();
        out.println(next.substring(0, 1).toUpperCase(Locale.ROOT) + next.substring(1) + "; help lists all commands.");
    }
}
