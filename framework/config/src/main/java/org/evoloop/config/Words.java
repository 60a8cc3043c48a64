package org.evoloop.config;

import java.util.ArrayList;
import java.util.List;
import java.util.ListIterator;
import java.util.Optional;
import java.util.function.Function;

/** Reads a command line: {@code --name value}, {@code --name=value} and {@code --flag}. */
final class Words {
    private final Function<String, Optional<Option<?>>> options;
    private final Mistakes mistakes;

    /** @param options finds an option by its name */
    Words(Function<String, Optional<Option<?>>> options, Mistakes mistakes) {
        this.options = options;
        this.mistakes = mistakes;
    }

    List<Entry> read(List<String> arguments) {
        List<Entry> entries = new ArrayList<>();
        for (ListIterator<String> rest = arguments.listIterator(); rest.hasNext(); ) {
            String word = rest.next();
            if (!isOption(word)) {
                mistakes.at(
                        Origin.COMMAND_LINE,
                        "'" + word
                                + "' does not belong to an option; options begin with --, and values with spaces are "
                                + "quoted");
                continue;
            }
            String[] parts = word.substring(2).split("=", 2);
            Optional<Option<?>> option = options.apply(parts[0]);
            if (parts.length == 2) {
                entries.add(Entry.of(parts[0], parts[1], Origin.COMMAND_LINE));
            } else if (option.isPresent() && option.get().isFlag()) {
                entries.add(Entry.of(parts[0], "true", Origin.COMMAND_LINE));
            } else {
                Optional<String> value = valueIn(rest);
                // The unknown option is reported later; its value must not be a second mistake.
                if (value.isPresent() || option.isEmpty()) {
                    entries.add(Entry.of(parts[0], value.orElse(""), Origin.COMMAND_LINE));
                } else {
                    String name = "--" + parts[0];
                    mistakes.in(
                            option.get().name(),
                            Origin.COMMAND_LINE,
                            name + " needs a value: " + name + " "
                                    + option.get().label());
                }
            }
        }
        return entries;
    }

    private static Optional<String> valueIn(ListIterator<String> rest) {
        if (!rest.hasNext()) {
            return Optional.empty();
        }
        String next = rest.next();
        if (isOption(next)) {
            rest.previous();
            return Optional.empty();
        }
        return Optional.of(next);
    }

    private static boolean isOption(String word) {
        return word.startsWith("--");
    }
}
