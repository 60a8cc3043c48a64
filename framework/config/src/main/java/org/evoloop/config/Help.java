package org.evoloop.config;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** The text that {@code --help} prints. */
final class Help {
    private static final int WIDTH = 100;

    private final Options options;

    Help(Options options) {
        this.options = options;
    }

    @Override
    public String toString() {
        List<String> usage = options.all()
                .map(option -> "[" + usage(option) + "]" + (option.repeats() ? "..." : ""))
                .toList();
        String begin = "usage: " + options.program() + " ";
        int column = 4
                + options.all().mapToInt(option -> usage(option).length()).max().orElse(0);
        StringBuilder text = new StringBuilder();
        wrap(text, begin, 7, usage);
        text.append('\n');
        wrap(text, "", 0, words(options.purpose()));
        text.append('\n');
        options.all()
                .forEach(option -> wrap(
                        text,
                        String.format(Locale.ROOT, "  %-" + (column - 2) + "s", usage(option)),
                        column,
                        words(option.description())));
        return text.append("\nExit status: 0 success, 2 wrong usage or input.\n")
                .toString();
    }

    private static String usage(Option<?> option) {
        return "--" + option.name() + (option.isFlag() ? "" : " " + option.label());
    }

    private static List<String> words(String text) {
        return List.of(text.split(" "));
    }

    private static void wrap(StringBuilder text, String begin, int indent, List<String> words) {
        List<String> line = new ArrayList<>();
        int length = begin.length();
        text.append(begin);
        for (String word : words) {
            if (!line.isEmpty() && length + 1 + word.length() > WIDTH) {
                text.append(String.join(" ", line)).append('\n').append(" ".repeat(indent));
                line.clear();
                length = indent;
            }
            length += word.length() + (line.isEmpty() ? 0 : 1);
            line.add(word);
        }
        text.append(line.stream().collect(Collectors.joining(" "))).append('\n');
    }
}
