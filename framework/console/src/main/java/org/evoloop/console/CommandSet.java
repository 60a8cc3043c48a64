package org.evoloop.console;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.statemachine.Names;

/**
 * The commands of a console by name; parses lines and performs them.
 *
 * <p>Threading: filled by one thread before the console runs, then used by any.
 */
final class CommandSet {
    private final Map<String, ConsoleCommand> commands = new LinkedHashMap<>();

    /** @throws IllegalArgumentException if there is a command of that name already */
    void add(ConsoleCommand command) {
        if (commands.putIfAbsent(command.name(), command) != null) {
            throw new IllegalArgumentException("there is a command named " + command.name() + " already");
        }
    }

    Collection<ConsoleCommand> all() {
        return commands.values();
    }

    Collection<String> names() {
        return commands.keySet();
    }

    /** @throws IllegalArgumentException if there is none of that name */
    ConsoleCommand require(String name) {
        ConsoleCommand command = commands.get(name);
        if (command == null) {
            throw new IllegalArgumentException("unknown command '" + Names.shown(name) + "'" + meant(name));
        }
        return command;
    }

    private String meant(String name) {
        String begun = names().stream()
                .filter(known -> name.length() > 1 && known.startsWith(name.toLowerCase(Locale.ROOT)))
                .collect(Collectors.joining(" or "));
        String near = begun.isEmpty() ? Names.meant(name, names()) : "; did you mean " + begun + "?";
        return near.isEmpty() ? "; help lists the commands" : near;
    }

    /** The words that may follow {@code before}. */
    Collection<String> completions(List<String> before) {
        if (before.isEmpty()) {
            return names();
        }
        ConsoleCommand command = commands.get(before.get(0));
        return command == null ? List.of() : command.completion().apply(before.subList(1, before.size()));
    }

    /**
     * Performs the command in {@code line}; an empty line does nothing.
     *
     * @param waiting whether a press waits for its outcome if the line does not say
     * @throws IllegalArgumentException if there is no such command, or it takes other arguments
     * @throws Exception whatever the command throws
     */
    void perform(String line, PrintStream out, boolean waiting) throws Exception {
        perform(split(line), out, waiting);
    }

    /** As the other method, for a line that has been split into words. */
    void perform(List<String> words, PrintStream out, boolean waiting) throws Exception {
        if (!words.isEmpty()) {
            ConsoleCommand command = require(words.get(0));
            List<String> arguments = words.subList(1, words.size());
            PressAction press = command.action() instanceof PressAction pressing ? pressing : null;
            if (!command.accepts((press == null ? arguments : PressAction.named(arguments)).size())) {
                throw new IllegalArgumentException("usage: " + command.usage());
            }
            // In one piece, since other threads print meanwhile.
            try (PrintStream into = new PrintStream(new Pieces(out), false, StandardCharsets.UTF_8)) {
                if (press == null) {
                    command.action().run(arguments, into);
                } else {
                    press.run(arguments, into, waiting);
                }
            }
        }
    }

    /** Passes on what it is given when it is flushed, in one piece. */
    private static final class Pieces extends ByteArrayOutputStream {
        private final PrintStream to;

        Pieces(PrintStream to) {
            this.to = to;
        }

        @Override
        public synchronized void flush() {
            if (size() > 0) {
                to.print(toString(StandardCharsets.UTF_8));
                to.flush();
                reset();
            }
        }
    }

    /** The words of a line, separated by blanks except between two quotes of the same kind. */
    static List<String> split(String line) {
        List<String> words = new ArrayList<>();
        StringBuilder word = new StringBuilder();
        boolean inWord = false;
        char quote = 0;
        for (int i = 0; i < line.length(); i++) {
            char next = line.charAt(i);
            if (quote != 0 && next == quote) {
                quote = 0;
            } else if (quote == 0 && (next == '"' || next == '\'')) {
                quote = next;
                inWord = true;
            } else if (quote == 0 && Character.isWhitespace(next)) {
                if (inWord) {
                    words.add(word.toString());
                }
                word.setLength(0);
                inWord = false;
            } else {
                word.append(next);
                inWord = true;
            }
        }
        if (quote != 0) {
            throw new IllegalArgumentException("the quote " + quote + " is not closed");
        }
        if (inWord) {
            words.add(word.toString());
        }
        return words;
    }
}
