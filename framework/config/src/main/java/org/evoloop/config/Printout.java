package org.evoloop.config;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The effective values, as an equivalent file: a line for each option, followed by the origin of its value. */
final class Printout {
    private static final Pattern DEFAULT = Pattern.compile("\\(default: (.+?)\\)");

    /** Texts and numbers that every YAML version reads literally. */
    private static final Pattern PLAIN = Pattern.compile("0|[1-9][0-9]*(?:\\.[0-9]+)?|[a-zA-Z/][a-zA-Z0-9/_.+=-]*");

    private static final Pattern WORD = Pattern.compile("(?i)y|n|yes|no|on|off|null|true|false");
    private static final int COMMENTS = 40;

    private final Options options;
    private final Settings settings;

    Printout(Options options, Settings settings) {
        this.options = options;
        this.settings = settings;
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        if (!options.program().isEmpty()) {
            line(text, "program: " + options.program(), "what this file is for");
        }
        options.declared().forEach(option -> append(text, option));
        options.secrets()
                .forEach(secret -> text.append("# " + secret.name() + ": " + secret.shown(settings))
                        .append('\n'));
        return text.toString();
    }

    private void append(StringBuilder text, Option<?> option) {
        Optional<Setting> setting = settings.setting(option);
        String usual = option.usual();
        if (setting.isPresent()) {
            line(
                    text,
                    option.name() + ": " + value(option, setting.get()),
                    setting.get().origin().toString());
        } else if (usual != null) {
            line(text, option.name() + ": " + (option.isFlag() ? usual : scalar(usual)), "default");
        } else {
            Matcher described = DEFAULT.matcher(option.description());
            line(text, "# " + option.name() + ":", "default: " + (described.find() ? described.group(1) : "not set"));
        }
    }

    private static void line(StringBuilder text, String left, String comment) {
        text.append(
                String.format(Locale.ROOT, "%-" + COMMENTS + "s  # %s%n", left, comment.replaceAll("\\p{Cntrl}", "?")));
    }

    private static String value(Option<?> option, Setting setting) {
        if (option.isFlag()) {
            return String.valueOf(setting.values().get(0));
        }
        Path here = Path.of("").toAbsolutePath();
        List<String> texts = setting.texts().stream()
                .map(text -> setting.origin().isFile() ? text : option.placed(here, text))
                .map(text -> scalar(Masked.urls(option.shown(text))))
                .toList();
        return texts.size() == 1 ? texts.get(0) : texts.stream().collect(Collectors.joining(", ", "[", "]"));
    }

    private static String scalar(String text) {
        if (PLAIN.matcher(text).matches() && !WORD.matcher(text).matches()) {
            return text;
        }
        if (text.codePoints().noneMatch(Printout::isEscaped)) {
            return "'" + text.replace("'", "''") + "'";
        }
        StringBuilder quoted = new StringBuilder("\"");
        text.codePoints()
                .forEach(each -> quoted.append(
                        each == '"' || each == '\\'
                                ? "\\" + (char) each
                                : isEscaped(each)
                                        ? String.format(Locale.ROOT, "\\u%04X", each)
                                        : Character.toString(each)));
        return quoted.append('"').toString();
    }

    /** Whether it would not be read as it is: a control character, a line separator, or half of a surrogate pair. */
    private static boolean isEscaped(int codePoint) {
        int type = Character.getType(codePoint);
        return type == Character.CONTROL
                || type == Character.LINE_SEPARATOR
                || type == Character.PARAGRAPH_SEPARATOR
                || type == Character.SURROGATE;
    }
}
