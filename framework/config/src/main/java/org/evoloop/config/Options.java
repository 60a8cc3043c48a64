package org.evoloop.config;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.statemachine.Names;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The options of a program, or of a part of one, and the checks across them. Picocli reads them from the command line,
 * and prints their help.
 *
 * <p>Besides them every program has {@code --config FILE}, which names a file with some of them, {@code --print-config}
 * and {@code --help}; {@link Settings#answer} handles the latter two.
 *
 * <p>Threading: immutable, if the checks are.
 *
 * @since 0.1
 */
public final class Options {
    private static final int WIDTH = 100;

    static final Option<Path> CONFIG =
            Option.path("config", "FILE", "Reads options from this YAML file, as NAME: VALUE; the command line wins.");
    static final Option<Boolean> PRINT_CONFIG =
            Option.flag("print-config", "Only prints what is in force and where it came from, as such a file.");

    /** The options that every program has, and that cannot be in a file. */
    static final List<Option<?>> OWN = List.of(CONFIG, PRINT_CONFIG);

    /** The first line of a file, which names the program to start with it. */
    private static final String PROGRAM = "program";

    private final String program;
    private final String purpose;
    private final @Nullable Object command;
    private final List<Option<?>> declared;
    private final List<Secret> secrets;
    private final List<Condition> checks;

    /** A check across several options. */
    @FunctionalInterface
    public interface Condition {
        /**
         * Adds a mistake for each violation.
         *
         * @param settings the settings without a mistake of their own
         */
        void check(Settings settings, Mistakes mistakes);
    }

    private Options(
            String program,
            String purpose,
            @Nullable Object command,
            List<Option<?>> declared,
            List<Secret> secrets,
            List<Condition> checks) {
        this.program = program;
        this.purpose = purpose;
        this.command = command;
        this.declared = List.copyOf(declared);
        this.secrets = List.copyOf(secrets);
        this.checks = List.copyOf(checks);
    }

    /** Options that belong together. */
    public static Options of(Option<?>... options) {
        return new Options("", "", null, List.of(options), List.of(), List.of());
    }

    /**
     * A program, without options so far.
     *
     * @param program its name, which a file for it gives after {@code program:}
     * @param purpose what it does, for its help
     */
    public static Options named(String program, String purpose) {
        return new Options(program, purpose, null, List.of(), List.of(), List.of());
    }

    /**
     * A program whose options are the annotated fields of a picocli command, which {@link #read} sets.
     *
     * @param command an object of a class with picocli's annotations, which give the program's name and its help
     */
    public static Options annotated(Object command) {
        CommandSpec spec = CommandSpec.forAnnotatedObject(command);
        List<Option<?>> options = new ArrayList<>();
        for (OptionSpec option : spec.options()) {
            if (!option.usageHelp() && !option.versionHelp()) {
                options.add(Option.annotated(option));
            }
        }
        return new Options(spec.name(), "", command, options, List.of(), List.of());
    }

    /** These options and others. */
    public Options and(Options... others) {
        Options all = this;
        for (Options more : others) {
            all = new Options(
                    program,
                    purpose,
                    command,
                    joined(all.declared, more.declared),
                    joined(all.secrets, more.secrets),
                    joined(all.checks, more.checks));
        }
        return all;
    }

    /** A copy with a secret, and the option that names its file. */
    public Options with(Secret secret) {
        return new Options(
                program,
                purpose,
                command,
                joined(declared, List.of(secret.file())),
                joined(secrets, List.of(secret)),
                checks);
    }

    /** A copy with another check. */
    public Options checking(Condition check) {
        return new Options(program, purpose, command, declared, secrets, joined(checks, List.of(check)));
    }

    /**
     * A copy in which one option is changed, such as one with picocli's annotations, which cannot say all of it.
     *
     * @param name of the option, without dashes
     */
    public Options refined(String name, UnaryOperator<Option<?>> change) {
        List<Option<?>> options = new ArrayList<>(declared);
        options.replaceAll(option -> option.isCalled(name) ? change.apply(option) : option);
        return new Options(program, purpose, command, options, secrets, checks);
    }

    /** A copy in which each of these options, given on the command line, overrides the others of the file. */
    public Options alternatives(String... names) {
        Options all = this;
        for (String name : names) {
            all = all.refined(name, option -> {
                Set<String> others = new TreeSet<>(option.insteadOf());
                others.addAll(List.of(names));
                others.remove(name);
                return option.insteadOf(others);
            });
        }
        return all;
    }

    private static <T> List<T> joined(List<? extends T> some, List<? extends T> others) {
        List<T> all = new ArrayList<>(some);
        all.addAll(others);
        return all;
    }

    /** Picocli's command line with all of these options; a new one for each call. */
    public CommandLine commandLine() {
        CommandSpec spec = command == null
                ? CommandSpec.create().name(program).mixinStandardHelpOptions(false)
                : CommandSpec.forAnnotatedObject(command);
        all().filter(option -> !spec.optionsMap().containsKey("--" + option.name()))
                .forEach(option ->
                        spec.addOption(OptionSpec.builder(option.spec()).build()));
        if (command == null) {
            spec.addOption(OptionSpec.builder("-h", "--help")
                    .usageHelp(true)
                    .description("Only prints this text.")
                    .build());
            spec.usageMessage()
                    .description(purpose.replace("%", "%%"))
                    .sortOptions(false)
                    .footer("", "Exit status: 0 success, 2 wrong usage or input.");
        }
        return new CommandLine(spec).setUsageHelpWidth(WIDTH).setExpandAtFiles(false);
    }

    /**
     * Reads and checks all options of the program.
     *
     * @param environment where secrets may be
     * @throws ConfigException if there are mistakes; it lists all of them
     */
    public Settings read(List<String> arguments, Map<String, String> environment) {
        return read(arguments, environment, IllegalArgumentException.class::isInstance);
    }

    /**
     * Reads and checks all options of the program.
     *
     * @param environment where secrets may be
     * @param mistake whether a failure to read a value is a mistake of the user
     * @throws ConfigException if there are mistakes; it lists all of them
     */
    public Settings read(List<String> arguments, Map<String, String> environment, Predicate<RuntimeException> mistake) {
        return read(arguments, List.of(), environment, mistake);
    }

    /**
     * As {@link #read(List, Map)}, with options of another file, over which the command line and the file of {@code
     * --config} win.
     */
    public Settings read(List<String> arguments, List<OptionLine> others, Map<String, String> environment) {
        return read(arguments, others, environment, IllegalArgumentException.class::isInstance);
    }

    private Settings read(
            List<String> arguments,
            List<OptionLine> others,
            Map<String, String> environment,
            Predicate<RuntimeException> mistake) {
        Mistakes mistakes = new Mistakes();
        Reading reading = new Reading(this, arguments, mistakes, mistake);
        if (reading.asksForHelp()) {
            return new Settings(this, Map.of(), environment, reading.help());
        }
        List<Entry> lines = new ArrayList<>();
        reading.file().ifPresent(file -> lines.addAll(ConfigFile.read(file, mistakes)));
        lines.removeIf(entry -> entry.name().equals(PROGRAM) && isProgram(entry, mistakes));
        Set<String> named = lines.stream().map(Entry::name).collect(Collectors.toSet());
        others.stream()
                .filter(each -> !named.contains(each.name()))
                .map(OptionLine::entry)
                .forEach(lines::add);
        Settings settings = new Settings(this, reading.with(lines), environment, "");
        for (Secret secret : secrets) {
            mistakes.tried(secret.file().name(), IllegalArgumentException.class::isInstance, () -> secret.in(settings));
        }
        checks.forEach(check -> check.check(settings, mistakes));
        mistakes.throwIfAny();
        return settings;
    }

    /**
     * The mistakes in the values of these options, by themselves: what concerns several options, or what the command line
     * may change, is found by {@link #read(List, List, Map)}.
     *
     * @param refused receives the line and what is wrong with it
     */
    public void check(List<OptionLine> lines, BiConsumer<Integer, String> refused) {
        Mistakes mistakes = new Mistakes();
        new Reading(this, List.of(), mistakes, IllegalArgumentException.class::isInstance)
                .with(lines.stream().map(OptionLine::entry).toList());
        mistakes.forEach(refused);
    }

    private boolean isProgram(Entry entry, Mistakes mistakes) {
        List<String> named = entry.values().stream().map(Entry.Value::text).toList();
        if (entry.readable() && !named.equals(List.of(program))) {
            mistakes.at(
                    entry.origin(),
                    "program is " + Names.shown(String.join(", ", named)) + ", but this is " + program
                            + "; name another file, or correct the line");
        }
        return true;
    }

    Optional<Option<?>> find(String name) {
        return all().filter(option -> option.isCalled(name)).findFirst();
    }

    /** The names of these options, without dashes; those that every program has are not among them. */
    public List<String> names() {
        return declared.stream().<String>map(Option::name).toList();
    }

    /** All names that a command line may have. */
    List<String> allNames() {
        return Stream.concat(all().map(Option::name), Stream.of("help")).toList();
    }

    /** Those of the program, and those that every program has. */
    Stream<Option<?>> all() {
        return Stream.concat(declared.stream(), OWN.stream());
    }

    String program() {
        return program;
    }

    List<Option<?>> declared() {
        return declared;
    }

    List<Secret> secrets() {
        return secrets;
    }
}
