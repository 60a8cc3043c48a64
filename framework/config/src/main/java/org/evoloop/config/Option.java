package org.evoloop.config;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.BinaryOperator;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.OptionSpec;

/**
 * An option of a program, declared once: {@code --NAME VALUE} on the command line, {@code NAME: VALUE} in a file.
 *
 * <p>Threading: immutable, if its reader is.
 *
 * @param <T> the type of its values
 * @since 0.1
 */
public final class Option<T> {
    private static final int LONG = "--".length();

    private final OptionSpec spec;
    private final Function<String, T> reader;
    private BinaryOperator<String> placed = (folder, text) -> text;
    private UnaryOperator<String> shown = UnaryOperator.identity();
    private Set<String> insteadOf = Set.of();

    private Option(OptionSpec spec, Function<String, T> reader) {
        this.spec = spec;
        this.reader = reader;
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
                described(name, description)
                        .paramLabel(label)
                        .type(String.class)
                        .build(),
                reader);
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

    /** An option that is on or off, and off unless it is given. */
    public static Option<Boolean> flag(String name, String description) {
        return new Option<>(described(name, description).type(boolean.class).build(), Option::isOn);
    }

    /** An option of a command with picocli's annotations; picocli sets its values. */
    static Option<?> annotated(OptionSpec spec) {
        return spec.arity().max() == 0
                ? new Option<>(spec, Option::isOn)
                : new Option<>(spec, text -> text)
                        .placedBy(spec.type() == Path.class ? Option::resolved : (folder, text) -> text);
    }

    private static OptionSpec.Builder described(String name, String description) {
        return OptionSpec.builder("--" + name).description(description.replace("%", "%%"));
    }

    /** Resolves a path given relative to {@code folder}, so that it can be used from the working directory. */
    public static String resolved(String folder, String path) {
        return Path.of(folder).resolve(path).toString();
    }

    static Boolean isOn(String text) {
        return switch (text) {
            case "true", "True", "TRUE" -> true;
            case "false", "False", "FALSE" -> false;
            default ->
                throw new IllegalArgumentException("'" + text + "' is neither true nor false; write one of them");
        };
    }

    private <U> Option<U> copy(OptionSpec changed, Function<String, U> read) {
        Option<U> copy = new Option<>(changed, read);
        copy.placed = placed;
        copy.shown = shown;
        copy.insteadOf = insteadOf;
        return copy;
    }

    /** A copy that takes any number of values: repeated on a command line, as a list in a file. */
    public Option<T> repeated() {
        return copy(
                described(name(), description())
                        .paramLabel(spec.paramLabel())
                        .type(List.class)
                        .auxiliaryTypes(String.class)
                        .build(),
                reader);
    }

    /** A copy with a default value. */
    public Option<T> withDefault(String value) {
        return copy(OptionSpec.builder(spec).defaultValue(value).build(), reader);
    }

    /**
     * A copy with values that contain relative paths.
     *
     * @param resolve takes a directory and a value relative to it, and returns the value relative to the working
     *     directory
     */
    public Option<T> placedBy(BinaryOperator<String> resolve) {
        Option<T> copy = copy(spec, reader);
        copy.placed = resolve;
        return copy;
    }

    /**
     * A copy with values that may contain a secret, which {@code --print-config} does not print.
     *
     * @param without takes a value, and returns it without the secret
     */
    public Option<T> shownBy(UnaryOperator<String> without) {
        Option<T> copy = copy(spec, reader);
        copy.shown = without;
        return copy;
    }

    /** A copy that, when given on the command line, overrides these other options of the file. */
    public Option<T> insteadOf(Set<String> others) {
        Option<T> copy = copy(spec, reader);
        copy.insteadOf = Set.copyOf(others);
        return copy;
    }

    /** A copy with another check of its values, which throws an {@link IllegalArgumentException} if it refuses one. */
    public Option<T> checkedBy(Consumer<String> check) {
        return copy(spec, text -> {
            check.accept(text);
            return reader.apply(text);
        });
    }

    /** Its name, without dashes. */
    public String name() {
        return spec.longestName().substring(LONG);
    }

    /** Picocli's description of it. */
    OptionSpec spec() {
        return spec;
    }

    boolean isCalled(String name) {
        return Arrays.asList(spec.names()).contains("--" + name);
    }

    String label() {
        return spec.paramLabel();
    }

    String description() {
        return String.join(" ", spec.description()).replace("%%", "%");
    }

    boolean isFlag() {
        return spec.arity().max() == 0;
    }

    boolean repeats() {
        return spec.isMultiValue();
    }

    @Nullable
    String usual() {
        return isFlag() ? "false" : spec.defaultValue();
    }

    Set<String> insteadOf() {
        return insteadOf;
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
