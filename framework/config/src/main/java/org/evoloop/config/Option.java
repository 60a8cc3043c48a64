package org.evoloop.config;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.BinaryOperator;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * An option of a program, declared once: {@code --NAME VALUE} on the command line, {@code NAME: VALUE} in a file.
 *
 * <p>Threading: immutable, if its reader is.
 *
 * @param <T> the type of its values
 * @since 0.1
 */
public final class Option<T> {
    private final String name;
    private final List<String> otherNames;
    private final String label;
    private final String description;
    private final Function<String, T> reader;
    private final boolean repeats;
    private final @Nullable String usual;
    private final BinaryOperator<String> placed;
    private final UnaryOperator<String> shown;
    private final Set<String> insteadOf;

    private Option(
            String name,
            List<String> otherNames,
            String label,
            String description,
            Function<String, T> reader,
            boolean repeats,
            @Nullable String usual,
            BinaryOperator<String> placed,
            UnaryOperator<String> shown,
            Set<String> insteadOf) {
        this.name = name;
        this.otherNames = otherNames;
        this.label = label;
        this.description = description;
        this.reader = reader;
        this.repeats = repeats;
        this.usual = usual;
        this.placed = placed;
        this.shown = shown;
        this.insteadOf = insteadOf;
    }

    /**
     * An option with a value.
     *
     * @param name without dashes
     * @param label the placeholder of the value in a usage line, such as {@code FILE}
     * @param description one sentence
     * @param reader reads a value; throws an {@link IllegalArgumentException} that says what is wrong with it and what
     *     is allowed
     */
    public static <T> Option<T> value(String name, String label, String description, Function<String, T> reader) {
        return new Option<>(
                name,
                List.of(),
                label,
                description,
                reader,
                false,
                null,
                Option::asWritten,
                UnaryOperator.identity(),
                Set.of());
    }

    /** An option whose value is a path; in a file, a relative one is relative to the file's directory. */
    public static Option<Path> path(String name, String label, String description) {
        return value(name, label, description, text -> Path.of(text)).placedBy(Option::resolved);
    }

    /** An option whose value is the path of an existing file. */
    public static Option<Path> file(String name, String label, String description) {
        return value(name, label, description, text -> {
                    Path file = Path.of(text);
                    if (!Files.isReadable(file) || Files.isDirectory(file)) {
                        throw new IllegalArgumentException("--" + name + " is " + text + ", which "
                                + (Files.isDirectory(file)
                                        ? "is a directory; name a file in it"
                                        : Files.exists(file)
                                                ? "may not be read; let this program's user read it"
                                                : "does not exist; correct the path"));
                    }
                    return file;
                })
                .placedBy(Option::resolved);
    }

    private static String asWritten(String folder, String text) {
        return text;
    }

    private static String resolved(String folder, String text) {
        return Path.of(folder).resolve(text).toString();
    }

    /** An option that is on or off, and off unless it is given. */
    public static Option<Boolean> flag(String name, String description) {
        return new Option<>(
                name,
                List.of(),
                "",
                description,
                Option::onOrOff,
                false,
                "false",
                Option::asWritten,
                UnaryOperator.identity(),
                Set.of());
    }

    private static Boolean onOrOff(String text) {
        return switch (text) {
            case "true", "True", "TRUE" -> true;
            case "false", "False", "FALSE" -> false;
            default ->
                throw new IllegalArgumentException("'" + text + "' is neither true nor false; write one of them");
        };
    }

    /** A copy with additional names. */
    public Option<T> alsoCalled(List<String> names) {
        return new Option<>(
                name, List.copyOf(names), label, description, reader, repeats, usual, placed, shown, insteadOf);
    }

    /** A copy that takes any number of values: repeated on a command line, as a list in a file. */
    public Option<T> repeated() {
        return new Option<>(name, otherNames, label, description, reader, true, usual, placed, shown, insteadOf);
    }

    /** A copy with a default value. */
    public Option<T> withDefault(String value) {
        return new Option<>(name, otherNames, label, description, reader, repeats, value, placed, shown, insteadOf);
    }

    /**
     * A copy with values that contain relative paths.
     *
     * @param resolve takes a directory and a value relative to it, and returns the value relative to the working
     *     directory
     */
    public Option<T> placedBy(BinaryOperator<String> resolve) {
        return new Option<>(name, otherNames, label, description, reader, repeats, usual, resolve, shown, insteadOf);
    }

    /**
     * A copy with values that may contain a secret, which {@code --print-config} does not print.
     *
     * @param shown takes a value, and returns it without the secret
     */
    public Option<T> shownBy(UnaryOperator<String> shown) {
        return new Option<>(name, otherNames, label, description, reader, repeats, usual, placed, shown, insteadOf);
    }

    /** A copy that, when given on the command line, overrides these other options of the file. */
    public Option<T> insteadOf(Set<String> others) {
        return new Option<>(
                name, otherNames, label, description, reader, repeats, usual, placed, shown, Set.copyOf(others));
    }

    /** Its name, without dashes. */
    public String name() {
        return name;
    }

    /** The placeholder of its value; empty for a flag. */
    String label() {
        return label;
    }

    String description() {
        return description;
    }

    boolean isFlag() {
        return label.isEmpty();
    }

    boolean repeats() {
        return repeats;
    }

    @Nullable
    String usual() {
        return usual;
    }

    Set<String> insteadOf() {
        return insteadOf;
    }

    List<String> otherNames() {
        return otherNames;
    }

    /** The value relative to the working directory, from {@code text} relative to {@code folder}. */
    String placed(Path folder, String text) {
        return placed.apply(folder.toString(), text);
    }

    /** The value as others may see it. */
    String shown(String text) {
        return shown.apply(text);
    }

    /** @throws IllegalArgumentException if the option does not take this value */
    T read(String text) {
        return reader.apply(text);
    }
}
