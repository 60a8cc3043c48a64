package org.evoloop.device.file;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import org.evoloop.config.Masked;
import org.evoloop.statemachine.Names;

/**
 * The mistakes in a file, so that all of them can be reported at once, each with its line.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class Problems {
    private final Path file;
    private final List<Problem> found = new ArrayList<>();

    private record Problem(int line, String text) {}

    /** @param file for messages */
    public Problems(Path file) {
        this.file = file;
    }

    /** The file. */
    public Path file() {
        return file;
    }

    /** Adds a mistake that concerns this part of the file. */
    public void at(Node place, String mistake) {
        at(place.line(), mistake);
    }

    /** Adds a mistake in this line, from 1; it shows no password that is in a URL. */
    public void at(int line, String mistake) {
        found.add(new Problem(line, Masked.urls(mistake)));
    }

    /**
     * Adds a mistake unless {@code name} is one of {@code known}.
     *
     * @param mistake what is said then, before the nearest of them
     */
    public void requireOneOf(Node.Text name, Collection<String> known, String mistake) {
        if (!known.contains(name.value())) {
            at(name, mistake + Names.hint(name.value(), known));
        }
    }

    /** Whether there is any. */
    public boolean isEmpty() {
        return found.isEmpty();
    }

    /** The mistakes in the order of their lines: {@code fan.yaml:3: ...}. */
    public List<String> all() {
        return found.stream()
                .sorted(Comparator.comparingInt(Problem::line))
                .map(each -> file + ":" + each.line() + ": " + each.text())
                .distinct()
                .toList();
    }

    /**
     * Reports all mistakes.
     *
     * @throws DeviceFileException with a line for each, if there is any
     */
    public void throwIfAny() {
        if (!found.isEmpty()) {
            throw new DeviceFileException(String.join("\n", all()));
        }
    }
}
