package org.evoloop.console;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * What a person can type next: {@code start}, then the events that lead on from the current state.
 *
 * <p>Threading: any thread.
 */
final class NextStep {
    private static final int MOST = 3;

    private NextStep() {}

    /**
     * A sentence without its full stop.
     *
     * @param prefix the prefix of this converter's commands, such as {@code "door "}; empty for the first converter
     * @param offered the application's commands for this converter
     */
    static String after(SystemEventConverter converter, String prefix, List<ConsoleCommand> offered) {
        ConverterStatus status = converter.status();
        if (status.loop() != LoopState.RUNNING) {
            return "type " + prefix + "start to convert events";
        }
        if (status.link() != null && !status.link().up()) {
            return "the device cannot be reached; " + prefix + "watch shows when it is back";
        }
        Set<String> acceptable = acceptable(converter);
        return offered.stream()
                .filter(ConsoleCommand::offered)
                .map(command -> typed(command).filter(line -> acceptable.contains(plain(lastWord(line)))))
                .map(fitting -> fitting.limit(MOST).collect(Collectors.joining(" or ")))
                .filter(line -> !line.isEmpty())
                .findFirst()
                .map(line -> "type " + line)
                .orElse(prefix + "watch shows what happens");
    }

    /** The events that lead on from here, as they are typed. */
    private static Set<String> acceptable(SystemEventConverter converter) {
        State here = converter.knowledge().getCurrentState();
        return converter.knowledge().models().evolved().transitionsFrom(here).stream()
                .map(Transition::event)
                .map(event -> plain(event.name()))
                .collect(Collectors.toSet());
    }

    /** The lines that call {@code command}, as far as they are known. */
    private static Stream<String> typed(ConsoleCommand command) {
        if (command.accepts(0)) {
            return Stream.of(command.name());
        }
        if (!command.accepts(1)) {
            return Stream.of();
        }
        Collection<String> words = command.completion().apply(List.of());
        return words.stream().sorted().map(word -> command.name() + " " + word);
    }

    private static String lastWord(String line) {
        return line.substring(line.lastIndexOf(' ') + 1);
    }

    private static String plain(String name) {
        return name.replaceAll("\\s", "_").toLowerCase(Locale.ROOT);
    }
}
