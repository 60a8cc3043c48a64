package org.evoloop.program;

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
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/**
 * Options of a picocli command as options that may also stand in a file; and the other way round.
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
    private final Map<String, Set<String>> insteadOf = new HashMap<>();

    /**
     * The options of this command line.
     *
     * @param mendable whether a failure of a check is one that the user can mend
     */
    public CommandOptions(CommandLine line, Predicate<RuntimeException> mendable) {
        this.line = line;
        this.mendable = mendable;
    }

    /** A value that picocli takes for this option must also pass this. */
    public CommandOptions check(String option, Consumer<String> check) {
        checks.put(option, check);
        return this;
    }

    /** The option's values hold paths; those whose type is {@link Path} are known. */
    public CommandOptions placed(String option, BinaryOperator<String> resolve) {
        placed.put(option, resolve);
        return this;
    }

    /** One of these options is enough: given on the command line, it takes the place of the others of a file. */
    public CommandOptions alternatives(String... options) {
        for (String option : options) {
            Set<String> others = insteadOf.computeIfAbsent(option, name -> new HashSet<>());
            Arrays.stream(options).filter(other -> !other.equals(option)).forEach(others::add);
        }
        return this;
    }

    /**
     * The command's options, but those that only ask for help.
     *
     * @param elsewhere those that are declared there, which the command only {@linkplain #show shows}
     * @return all of them
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
                .insteadOf(others);
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

    /** A path as it is written in the working directory, if it is written like this in {@code folder}. */
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

    /** Has a command's help and parser know options that are declared elsewhere. */
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
