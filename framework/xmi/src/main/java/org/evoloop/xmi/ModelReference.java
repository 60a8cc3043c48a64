package org.evoloop.xmi;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;

/**
 * A reference to a state machine in a file, as on a command line: {@code FILE#NAME}.
 *
 * <p>Threading: immutable.
 *
 * @param file the model file
 * @param machine diagram name, machine name or id; empty for the file's only machine
 * @param timeUnit the unit of time triggers given as a bare number, milliseconds or seconds; empty to refuse them
 * @since 0.1
 */
public record ModelReference(Path file, Optional<String> machine, Optional<ChronoUnit> timeUnit) {

    /** A reference that requires a unit in every time trigger. */
    public ModelReference(Path file, Optional<String> machine) {
        this(file, machine, Optional.empty());
    }

    /**
     * Parses an option's unit of time triggers.
     *
     * @param abbreviation {@code ms} or {@code s}
     * @throws ModelException for anything else
     */
    public static ChronoUnit unit(String abbreviation) {
        return switch (abbreviation.strip()) {
            case "ms" -> ChronoUnit.MILLIS;
            case "s" -> ChronoUnit.SECONDS;
            default ->
                throw new ModelException(
                        "--time-unit: '" + abbreviation + "' is not a unit of time triggers; give ms or s");
        };
    }

    /** A copy with a unit for time triggers. */
    public ModelReference withTimeUnit(Optional<ChronoUnit> unit) {
        return new ModelReference(file, machine, unit);
    }

    /**
     * Splits at the last {@code #}, unless the whole text is the path of something that exists.
     *
     * @throws ModelException if the file name is empty, or nothing follows the {@code #}
     */
    public static ModelReference parse(String text) {
        int hash = text.lastIndexOf('#');
        if (hash < 0 || Files.exists(path(text, text))) {
            return new ModelReference(path(text, text), Optional.empty());
        }
        String name = text.substring(hash + 1).strip();
        if (name.isEmpty()) {
            throw new ModelException(
                    "'" + text + "' names no state machine after '#'; write FILE#NAME, or FILE if it holds only one");
        }
        return new ModelReference(path(text.substring(0, hash), text), Optional.of(name));
    }

    private static Path path(String file, String text) {
        if (file.isBlank()) {
            throw new ModelException("'" + text + "' names no file; write FILE#NAME, for example robot.xml#original");
        }
        try {
            return Path.of(file);
        } catch (InvalidPathException notAPath) {
            throw new ModelException(
                    "'" + text + "' is not the path of a file (" + notAPath.getReason() + "); correct it", notAPath);
        }
    }

    /**
     * Reads the file and picks the machine.
     *
     * @throws ModelException as in {@link ModelFile#read}, {@link ModelFile#pick} and {@link ModelFile#only}
     */
    public StateMachine load() {
        return find().toStateMachine();
    }

    /**
     * Reads the file and finds the machine, unchecked.
     *
     * @throws ModelException as in {@link ModelFile#read}, {@link ModelFile#find} and {@link ModelFile#findOnly}
     */
    public XmiMachine find() {
        ModelFile whole = ModelFile.read(file);
        ModelFile read = timeUnit.map(whole::withTimeUnit).orElse(whole);
        return machine.isPresent() ? read.find(machine.get()) : read.findOnly();
    }

    /**
     * A file beside this one with the given ending. For the machine b of {@code a.xml} that is {@code a.b} plus the
     * ending if such a file exists, else {@code a} plus the ending, which may not exist.
     *
     * @param ending such as {@code .properties.txt}
     */
    public Path beside(String ending) {
        return machine.map(name -> named("." + name + ending))
                .filter(Files::exists)
                .orElseGet(() -> named(ending));
    }

    private Path named(String ending) {
        String name = String.valueOf(file.getFileName());
        int dot = name.lastIndexOf('.');
        return file.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + ending);
    }

    /** The text that {@link #parse} accepts. */
    @Override
    public String toString() {
        return machine.map(name -> file + "#" + name).orElse(file.toString());
    }
}
