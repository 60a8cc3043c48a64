package org.evoloop.config;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.evoloop.statemachine.Names;

/**
 * The options of a program, or of a part of one, and the checks across them.
 *
 * <p>Besides them every program has {@code --config FILE}, which names a file with some of them, {@code --print-config}
 * and {@code --help}; {@link Settings#answer} handles the latter two.
 *
 * <p>Threading: immutable, if the checks are.
 *
 * @since 0.1
 */
public final class Options {
    private static final Option<Path> CONFIG =
            Option.path("config", "FILE", "Reads options from this YAML file, as NAME: VALUE; the command line wins.");
    static final Option<Boolean> PRINT_CONFIG =
            Option.flag("print-config", "Only prints what is in force and where it came from, as such a file.");
    static final Option<Boolean> HELP = Option.flag("help", "Only prints this text.");

    /** The options that every program has, and that cannot be in a file. */
    static final List<Option<?>> OWN = List.of(CONFIG, PRINT_CONFIG, HELP);

    /** The first line of a file, which names the program to start with it. */
    private static final String PROGRAM = "program";

    private final String program;
    private final String purpose;
    private final List<Option<?>> declared;
    private final List<Secret> secrets;
    private final List<Check> checks;

    /** A check across several options. */
    @FunctionalInterface
    public interface Check {
        /**
         * Adds a mistake for each violation.
         *
         * @param settings the settings without a mistake of their own
         */
        void check(Settings settings, Mistakes mistakes);
    }

    /** Receives the description of options. */
    @FunctionalInterface
    public interface Shown {
        /** An option; its label is empty if it is a flag. */
        void option(Option<?> option, String label, String description);
    }

    private Options(
            String program, String purpose, List<Option<?>> declared, List<Secret> secrets, List<Check> checks) {
        this.program = program;
        this.purpose = purpose;
        this.declared = List.copyOf(declared);
        this.secrets = List.copyOf(secrets);
        this.checks = List.copyOf(checks);
    }

    /** Options that belong together. */
    public static Options of(Option<?>... options) {
        return new Options("", "", List.of(options), List.of(), List.of());
    }

    /**
     * A program, without options so far.
     *
     * @param program its name, which a file for it gives after {@code program:}
     * @param purpose what it does, for its help
     */
    public static Options named(String program, String purpose) {
        return new Options(program, purpose, List.of(), List.of(), List.of());
    }

    /** These options and others. */
    public Options and(Options... others) {
        Options all = this;
        for (Options more : others) {
            all = new Options(
                    program,
                    purpose,
                    joined(all.declared, more.declared),
                    joined(all.secrets, more.secrets),
                    joined(all.checks, more.checks));
        }
        return all;
    }

    /** A copy with a secret, and the option that names its file. */
    public Options with(Secret secret) {
        return new Options(
                program, purpose, joined(declared, List.of(secret.file())), joined(secrets, List.of(secret)), checks);
    }

    /** A copy with another check. */
    public Options checking(Check check) {
        return new Options(program, purpose, declared, secrets, joined(checks, List.of(check)));
    }

    private static <T> List<T> joined(List<? extends T> some, List<? extends T> others) {
        List<T> all = new ArrayList<>(some);
        all.addAll(others);
        return all;
    }

    /**
     * Reads and checks all options of the program.
     *
     * @param environment where secrets may be
     * @throws ConfigException if there are mistakes; it lists all of them
     */
    public Settings read(List<String> arguments, Map<String, String> environment) {
        Mistakes mistakes = new Mistakes();
        List<Entry> words = new Words(this::find, mistakes).read(arguments);
        if (words.stream().anyMatch(entry -> entry.name().equals(HELP.name()))) {
            return new Settings(
                    this, Map.of(HELP, new Setting(Origin.COMMAND_LINE, List.of("true"), List.of(true))), environment);
        }
        List<Entry> lines = new ArrayList<>();
        words.stream()
                .filter(entry -> entry.name().equals(CONFIG.name()))
                .findFirst()
                .ifPresent(entry -> lines.addAll(
                        ConfigFile.read(Path.of(entry.values().get(0).text()), mistakes)));
        lines.removeIf(entry -> entry.name().equals(PROGRAM) && isProgram(entry, mistakes));
        Map<Option<?>, Setting> merged = new LinkedHashMap<>(new Merge(this, mistakes).merged(words, lines));
        Settings settings = new Settings(this, merged, environment);
        for (Secret secret : secrets) {
            mistakes.tried(secret.file().name(), IllegalArgumentException.class::isInstance, () -> secret.in(settings));
        }
        checks.forEach(check -> check.check(settings, mistakes));
        mistakes.throwIfAny();
        return settings;
    }

    /** Shows each option with its label and description, {@code --config} and {@code --print-config} included. */
    public void forEach(Shown shown) {
        all().filter(option -> option != HELP)
                .forEach(option -> shown.option(option, option.label(), option.description()));
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
        return all().filter(option ->
                        option.name().equals(name) || option.otherNames().contains(name))
                .findFirst();
    }

    List<String> names() {
        return all().map(Option::name).toList();
    }

    /** Those of the program, and those that every program has. */
    Stream<Option<?>> all() {
        return Stream.concat(declared.stream(), OWN.stream());
    }

    String program() {
        return program;
    }

    String purpose() {
        return purpose;
    }

    List<Option<?>> declared() {
        return declared;
    }

    List<Secret> secrets() {
        return secrets;
    }
}
