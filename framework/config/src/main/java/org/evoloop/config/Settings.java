package org.evoloop.config;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;

/**
 * The options given to a program, from all sources.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Settings {
    private final Options options;
    private final Map<Option<?>, Setting> given;
    private final Map<String, String> environment;
    private final String help;
    private final Map<Path, String> secrets = new ConcurrentHashMap<>();

    /** @param help the answer to {@code --help}; empty if that was not asked for */
    Settings(Options options, Map<Option<?>, Setting> given, Map<String, String> environment, String help) {
        this.options = options;
        this.given = given;
        this.environment = environment;
        this.help = help;
    }

    /** The value of an option, or its default; empty if there is neither. */
    public <T> Optional<T> get(Option<T> option) {
        List<T> values = all(option);
        return values.isEmpty() ? Optional.empty() : Optional.of(values.get(values.size() - 1));
    }

    /** The values of an option that may be repeated, or its default. */
    @SuppressWarnings("unchecked") // made by the option's own reader
    public <T> List<T> all(Option<T> option) {
        Setting setting = given.get(option);
        if (setting != null) {
            return (List<T>) setting.values();
        }
        String usual = option.usual();
        return usual == null ? List.of() : List.of(option.read(usual));
    }

    /** Whether a flag is on. */
    public boolean isOn(Option<Boolean> flag) {
        return get(flag).orElse(false);
    }

    /** Whether {@code --print-config} was given, so that nothing will be started. */
    public boolean isOnlyShown() {
        return isOn(Options.PRINT_CONFIG);
    }

    /**
     * Answers {@code --help} and {@code --print-config}.
     *
     * @return if one of them was given, the exit status of the program, which has nothing else to do: 0, or 1 if the
     *     answer could not be written in full, as to a full disk
     */
    public OptionalInt answer(PrintStream out, PrintStream err) {
        if (!help.isEmpty()) {
            out.print(help);
        } else if (isOnlyShown()) {
            out.print(new Printout(options, this));
        } else {
            return OptionalInt.empty();
        }
        if (out.checkError()) {
            err.println("error: standard output: the result could not be written in full; free some space there, or"
                    + " write it elsewhere");
            return OptionalInt.of(1);
        }
        return OptionalInt.of(0);
    }

    Optional<Setting> setting(Option<?> option) {
        return Optional.ofNullable(given.get(option));
    }

    /** The secret in a file; it is read once, since the file may be a pipe. */
    String secret(Path file, Function<Path, String> reader) {
        return secrets.computeIfAbsent(file, reader);
    }

    Map<String, String> environment() {
        return environment;
    }
}
