package org.evoloop.service;

import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How a program runs by itself.
 *
 * @param start whether the loop is opened at once, and the end of the standard input ends nothing
 * @param name the name under which {@code ctl} reaches it; null if it has no control socket
 * @param journal the directory in which its converter keeps its journal; null if it keeps none
 * @since 0.1
 */
public record ServiceOptions(
        boolean start, @Nullable String name, @Nullable Path journal) {
    /** The names of the options, as they stand in a usage line. */
    public static final String USAGE = "[--start] [--name NAME] [--journal DIR]";

    /** @throws IllegalArgumentException if the name is not one */
    public ServiceOptions {
        if (name != null) {
            Instances.requireName(name);
        }
    }

    /** An ordinary program with a console: nothing starts by itself, and nothing listens. */
    public static ServiceOptions none() {
        return new ServiceOptions(false, null, null);
    }

    /**
     * Takes {@code --start}, {@code --name NAME} and {@code --journal DIR} out of a command line.
     *
     * @param arguments a list that can be changed; what is left is the program's own
     * @throws IllegalArgumentException if the name or the directory is missing, or the name is not one
     */
    public static ServiceOptions takeFrom(List<String> arguments) {
        boolean start = false;
        String name = null;
        Path journal = null;
        for (Iterator<String> rest = arguments.iterator(); rest.hasNext(); ) {
            String next = rest.next();
            if (next.equals("--start")) {
                start = true;
                rest.remove();
            } else if (next.equals("--name")) {
                name = value(rest, "--name needs a name, as in --name lamp");
            } else if (next.equals("--journal")) {
                journal = Path.of(value(rest, "--journal needs a directory, as in --journal /var/lib/lamp"));
            }
        }
        return new ServiceOptions(start, name, journal);
    }

    private static String value(Iterator<String> rest, String missing) {
        rest.remove();
        if (!rest.hasNext()) {
            throw new IllegalArgumentException(missing);
        }
        String value = rest.next();
        rest.remove();
        return value;
    }
}
