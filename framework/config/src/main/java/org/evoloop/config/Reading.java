package org.evoloop.config;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import org.evoloop.config.Entry.Value;
import org.evoloop.statemachine.Names;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;

/**
 * Has picocli read a command line, and then again with a file's lines in front of it, but for those of options that the
 * command line has. So a value is read, and refused, in the same way wherever it is.
 */
final class Reading {
    private final Options options;
    private final List<String> arguments;
    private final Mistakes mistakes;
    private final Predicate<RuntimeException> users;
    private final CommandLine line;
    private final Set<Option<?>> given = new HashSet<>();
    private final Map<Option<?>, Entry> inFile = new LinkedHashMap<>();
    private ParseResult parsed;

    /** @param users whether a failure to read a value is a mistake of the user */
    Reading(Options options, List<String> arguments, Mistakes mistakes, Predicate<RuntimeException> users) {
        this.options = options;
        this.mistakes = mistakes;
        this.users = users;
        this.line = options.commandLine()
                .registerConverter(boolean.class, Option::isOn)
                .registerConverter(double.class, reading(Double::valueOf, "number"))
                .registerConverter(Double.class, reading(Double::valueOf, "number"))
                .registerConverter(int.class, reading(Integer::valueOf, "whole number"))
                .registerConverter(Integer.class, reading(Integer::valueOf, "whole number"))
                .setUnmatchedArgumentsAllowed(true);
        line.getCommandSpec().parser().collectErrors(true);
        this.arguments = complete(arguments);
        this.parsed = parse(this.arguments);
        parsed.matchedOptions().forEach(spec -> option(spec).ifPresent(given::add));
        parsed.errors().forEach(problem -> option((ParameterException) problem).ifPresent(given::add));
    }

    /** Reads a number, with a message of its own. */
    private static <T> ITypeConverter<T> reading(Function<String, T> number, String kind) {
        return text -> {
            try {
                return number.apply(text);
            } catch (NumberFormatException none) {
                throw new TypeConversionException("'" + text + "' is not a " + kind);
            }
        };
    }

    /** The words but for options whose value is missing. Picocli would take the next option as a value. */
    private List<String> complete(List<String> words) {
        List<String> complete = new ArrayList<>();
        for (int at = 0; at < words.size(); at++) {
            String word = words.get(at);
            Option<?> option =
                    word.startsWith("--") ? options.find(word.substring(2)).orElse(null) : null;
            if (option == null || option.isFlag()) {
                complete.add(word);
            } else if (at + 1 < words.size() && !words.get(at + 1).startsWith("--")) {
                complete.add(word);
                complete.add(words.get(++at));
            } else {
                given.add(option);
                mistakes.in(
                        option.name(), Origin.COMMAND_LINE, word + " needs a value: " + word + " " + option.label());
            }
        }
        return complete;
    }

    private ParseResult parse(List<String> words) {
        return line.parseArgs(words.toArray(String[]::new));
    }

    boolean asksForHelp() {
        return parsed.isUsageHelpRequested();
    }

    String help() {
        return line.getUsageMessage();
    }

    /** The file with further options. */
    Optional<Path> file() {
        return Optional.ofNullable(parsed.matchedOptionValue("--" + Options.CONFIG.name(), (String) null))
                .filter(file -> !file.isEmpty())
                .map(Path::of);
    }

    /** The options of the command line, and of these lines of the file. */
    Map<Option<?>, Setting> with(List<Entry> lines) {
        given.forEach(option -> mistakes.knows(option.name(), Origin.COMMAND_LINE));
        inFile.putAll(known(lines));
        for (Option<?> option : given) {
            inFile.keySet()
                    .removeIf(other -> other == option || option.insteadOf().contains(other.name()));
        }
        inFile.forEach((option, entry) -> mistakes.knows(option.name(), entry.origin()));
        List<String> words = new ArrayList<>();
        inFile.forEach((option, entry) -> words.addAll(words(option, entry)));
        words.addAll(arguments);
        parsed = parse(words);
        unmatched(parsed.unmatched());
        for (Exception problem : parsed.errors()) {
            refuse((ParameterException) problem);
        }
        Map<Option<?>, Setting> settings = new LinkedHashMap<>();
        options.all().forEach(option -> setting(option).ifPresent(setting -> settings.put(option, setting)));
        return settings;
    }

    private Optional<Option<?>> option(ParameterException problem) {
        ArgSpec named =
                problem instanceof OverwrittenOptionException twice ? twice.getOverwritten() : problem.getArgSpec();
        return named instanceof OptionSpec spec ? option(spec) : Optional.empty();
    }

    private Optional<Option<?>> option(OptionSpec spec) {
        return options.find(spec.longestName().substring(2));
    }

    /** The lines of known options. */
    private Map<Option<?>, Entry> known(List<Entry> lines) {
        Map<Option<?>, Entry> known = new LinkedHashMap<>();
        for (Entry entry : lines) {
            Option<?> option = options.find(entry.name()).orElse(null);
            if (option == null) {
                unknown(entry.name(), entry.origin());
            } else if (Options.OWN.contains(option)) {
                mistakes.in(option.name(), entry.origin(), "--" + entry.name() + " belongs on the command line");
            } else {
                Entry before = known.putIfAbsent(option, entry);
                if (before != null) {
                    mistakes.in(
                            option.name(),
                            entry.origin(),
                            "--" + entry.name() + " is given twice, first in line "
                                    + before.origin().line()
                                    + (option.repeats() ? "; make one list of both" : "; keep one"));
                }
            }
        }
        return known;
    }

    /** A line of the file as words of a command line; none if they could not be read, or switch a flag off. */
    private List<String> words(Option<?> option, Entry entry) {
        if (!entry.readable()) {
            mistakes.spoils(option.name());
            return List.of();
        }
        if (entry.list() && !option.repeats()) {
            mistakes.in(option.name(), entry.origin(), "--" + option.name() + " takes one value, not a list");
            return List.of();
        }
        List<String> words = new ArrayList<>();
        for (Value value : entry.values()) {
            tried(option, value.origin(), () -> {
                String text = placed(option, value);
                if (!option.isFlag()) {
                    words.add("--" + option.name() + "=" + text);
                } else if (option.read(text).equals(true)) {
                    words.add("--" + option.name());
                }
            });
        }
        return words;
    }

    private static String placed(Option<?> option, Value value) {
        Path file = value.origin().file();
        Path folder = file == null ? null : file.toAbsolutePath().getParent();
        return folder == null || value.text().isEmpty() ? value.text() : option.placed(folder, value.text());
    }

    private void tried(Option<?> option, Origin place, Runnable read) {
        try {
            read.run();
        } catch (RuntimeException refused) {
            if (!users.test(refused)) {
                throw refused;
            }
            mistakes.in(option.name(), place, String.valueOf(refused.getMessage()));
        }
    }

    /** Words that belong to no option. The one after an unknown option may be its value, and is no second mistake. */
    private void unmatched(List<String> words) {
        boolean mayBeValue = false;
        for (String word : words) {
            boolean named = word.startsWith("--");
            if (named) {
                unknown(word.substring(2).replaceFirst("=.*", ""), Origin.COMMAND_LINE);
            } else if (!mayBeValue) {
                mistakes.at(
                        Origin.COMMAND_LINE,
                        "'" + word + "' does not belong to an option; options begin with --, and values with spaces "
                                + "are quoted");
            }
            mayBeValue = named && !word.contains("=");
        }
    }

    private void unknown(String name, Origin place) {
        String message = "there is no option --" + Names.shown(name);
        Optional<Secret> secret = options.secrets().stream()
                .filter(each -> each.name().equals(name))
                .findFirst();
        if (secret.isPresent()) {
            mistakes.at(
                    place,
                    message + ", since others could read it; put the secret into a file, and name that with --"
                            + secret.get().file().name());
            return;
        }
        String hint = Names.hint(name, options.allNames());
        boolean similar = hint.startsWith("; did you mean");
        mistakes.at(place, message + (similar ? hint : "; see " + options.program() + " --help"));
    }

    private void refuse(ParameterException problem) {
        Option<?> option = option(problem).orElse(null);
        if (option == null) {
            mistakes.at(Origin.COMMAND_LINE, String.valueOf(problem.getMessage()));
            return;
        }
        Throwable cause = problem.getCause();
        String why = cause == null ? problem.getMessage() : cause.getMessage();
        if (problem instanceof OverwrittenOptionException) {
            why = "--" + option.name() + " is given twice; keep one";
        } else if ("".equals(problem.getValue())) {
            why = isEmpty(option);
        }
        mistakes.in(option.name(), origin(option, problem.getValue()), String.valueOf(why));
    }

    private static String isEmpty(Option<?> option) {
        return "--" + option.name() + " has an empty value; write one, or leave it out";
    }

    private Origin origin(Option<?> option, @Nullable String text) {
        Entry entry = inFile.get(option);
        if (entry == null) {
            return Origin.COMMAND_LINE;
        }
        return entry.values().stream()
                .filter(value -> placed(option, value).equals(text))
                .map(Value::origin)
                .findFirst()
                .orElse(entry.origin());
    }

    /** The option's value; empty if it has none, or one that is refused. */
    private Optional<Setting> setting(Option<?> option) {
        Entry entry = inFile.get(option);
        List<String> texts = texts(option, entry);
        Origin origin = entry == null ? Origin.COMMAND_LINE : entry.origin();
        List<Object> values = new ArrayList<>();
        for (String text : texts) {
            tried(option, origin(option, text), () -> {
                if (text.isEmpty()) {
                    throw new IllegalArgumentException(isEmpty(option));
                }
                values.add(option.read(text));
            });
        }
        return mistakes.isFaulty(option.name()) || values.isEmpty()
                ? Optional.empty()
                : Optional.of(new Setting(origin, texts, values));
    }

    private List<String> texts(Option<?> option, @Nullable Entry entry) {
        if (parsed.hasMatchedOption("--" + option.name())) {
            OptionSpec spec = parsed.matchedOption("--" + option.name());
            return option.isFlag() ? List.of(String.valueOf(spec.<Object>getValue())) : spec.originalStringValues();
        }
        return entry != null && option.isFlag() ? List.of("false") : List.of();
    }
}
