package org.evoloop.console;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopState;

/** What somebody who sits down at a terminal sees: where the system stands, and what can be typed next. */
final class FirstScreen {
    private FirstScreen() {}

    /**
     * Prints it.
     *
     * @param converters the first one's commands have no name in front of them
     * @param offered the application's commands
     */
    static void show(List<SystemEventConverter> converters, List<ConsoleCommand> offered, PrintStream out) {
        converters.forEach(converter -> StatusText.brief(converter.status(), out));
        // Whichever is stopped is what somebody has to do something about.
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
