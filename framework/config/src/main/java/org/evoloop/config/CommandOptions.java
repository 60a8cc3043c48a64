package org.evoloop.config;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BinaryOperator;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/**
 * Makes the options of a picocli command available in an options file, and options declared elsewhere available to a
 * picocli command.
 *
 * <p>Threading: for one thread, as the command line is.
 *
 * @since 0.1
 */
public final class CommandOptions {
    private final CommandLine line;
    private final Predicate<RuntimeException> mendable;
    private final Map<String, Consumer<String>> checks = new HashMap<>();
    private final Map<String, BinaryOperator<String>> placed = new HashMap<>();
    private final Map<String, UnaryOperator<String>> shown = new HashMap<>();
    private final Map<String, Set<String>> insteadOf = new HashMap<>();

    /**
     * The options of this command line.
     *
     * @param mendable whether a failed check is a mistake that the user can fix
     */
    public CommandOptions(CommandLine line, Predicate<RuntimeException> mendable) {
        this.line = line;
        this.mendable = mendable;
    }

    /** Adds a check for this option's values, in addition to picocli's own. */
    public CommandOptions check(String option, Consumer<String> check) {
        checks.put(option, check);
        return this;
    }

    /** Declares that the option's values are paths. This is not needed for options of type {@link Path}. */
    public CommandOptions placed(String option, BinaryOperator<String> resolve) {
        placed.put(option, resolve);
        return this;
    }

    /** Declares that the option's values may contain a secret: see {@link Option#shownBy}. */
    public CommandOptions shown(String option, UnaryOperator<String> withoutSecret) {
        shown.put(option, withoutSecret);
        return this;
    }

    /**
     * Declares alternatives: if one of these options is given on the command line, the others in a file are ignored.
     */
    public CommandOptions alternatives(String... options) {
        for (String option : options) {
            Set<String> others = insteadOf.computeIfAbsent(option, name -> new HashSet<>());
            Arrays.stream(options).filter(other -> !other.equals(option)).forEach(others::add);
        }
        return this;
    }

    /**
     * The command's options, except those that only print help.
     *
     * @param elsewhere options declared elsewhere, which the command only {@linkplain #show shows}
     * @return all options
     */
    public Options and(Options elsewhere) {
        Set<String> known = new HashSet<>();
        elsewhere.forEach((option, label, description) -> known.add("--" + option.name()));
        return Options.of(line.getCommandSpec().options().stream()
                        .filter(option ->
                                !option.usageHelp() && !option.versionHelp() && !known.contains(option.longestName()))
                        .map(this::declared)
                        .toArray(Option<?>[]::new))
                .and(elsewhere);
    }

    private Option<?> declared(OptionSpec spec) {
        List<String> names = Arrays.stream(spec.names())
                .filter(name -> name.startsWith("--"))
                .map(name -> name.substring(2))
                .toList();
        String name = names.get(0);
        Set<String> others = insteadOf.getOrDefault(name, Set.of());
        String description = String.join(" ", spec.description());
        if (spec.arity().max() == 0) {
            return Option.flag(name, description).insteadOf(others);
        }
        Option<String> option = Option.value(name, spec.paramLabel(), description, text -> read(name, text))
                .alsoCalled(names.subList(1, names.size()))
                .insteadOf(others)
                .shownBy(shown.getOrDefault(name, UnaryOperator.identity()));
        BinaryOperator<String> resolve = placed.get(name);
        if (resolve != null) {
            option = option.placedBy(resolve);
        } else if (spec.type() == Path.class) {
            option = option.placedBy(CommandOptions::resolved);
        }
        String usual = spec.defaultValue();
        option = usual == null ? option : option.withDefault(usual);
        return spec.isMultiValue() ? option.repeated() : option;
    }

    /** Resolves a path given relative to {@code folder}, so that it can be used from the working directory. */
    public static String resolved(String folder, String path) {
        return Path.of(folder).resolve(path).toString();
    }

    private String read(String name, String text) {
        try {
            line.parseArgs("--" + name + "=" + text);
            checks.getOrDefault(name, any -> {}).accept(text);
            return text;
        } catch (ParameterException refused) {
            throw new IllegalArgumentException(
                    "--" + name + ": "
                            + String.valueOf(refused.getMessage())
                                    .replaceFirst("^Invalid value for option '[^']*'[^:]*: ", "")
                                    .replaceFirst(" is not a (?:double|float)$", " is not a number")
                                    .replaceFirst(" is not an (?:int|long)$", " is not a whole number"),
                    refused);
        } catch (RuntimeException refused) {
            if (mendable.test(refused)) {
                throw new IllegalArgumentException(refused.getMessage(), refused);
            }
            throw refused;
        }
    }

    /** Adds options declared elsewhere to a command's help and parser. */
    public static CommandLine show(CommandLine line, Options options) {
        options.forEach((option, label, description) -> {
            OptionSpec.Builder spec =
                    OptionSpec.builder("--" + option.name()).description(description.replace("%", "%%"));
            line.getCommandSpec()
                    .addOption((label.isEmpty()
                                    ? spec.arity("0").type(boolean.class)
                                    : spec.paramLabel(label).arity("1").type(String.class))
                            .build());
        });
        return line;
    }
}
