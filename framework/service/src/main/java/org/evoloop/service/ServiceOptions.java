package org.evoloop.service;

import java.util.Iterator;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How a program runs by itself.
 *
 * @param start whether the loop is opened at once, and the end of the standard input ends nothing
 * @param name the name under which {@code ctl} reaches it; null if it has no control socket
 * @since 0.1
 */
public record ServiceOptions(boolean start, @Nullable String name) {
    /** The names of the options, as they stand in a usage line. */
    public static final String USAGE = "[--start] [--name NAME]";

    /** @throws IllegalArgumentException if the name is not one */
    public ServiceOptions {
        if (name != null) {
            Instances.requireName(name);
        }
    }

    /** An ordinary program with a console: nothing starts by itself, and nothing listens. */
    public static ServiceOptions none() {
        return new ServiceOptions(false, null);
    }

    /**
     * Takes {@code --start} and {@code --name NAME} out of a command line.
     *
     * @param arguments a list that can be changed; what is left is the program's own
     * @throws IllegalArgumentException if the name is missing or not one
     */
    public static ServiceOptions takeFrom(List<String> arguments) {
        boolean start = false;
        String name = null;
        for (Iterator<String> rest = arguments.iterator(); rest.hasNext(); ) {
            String next = rest.next();
            if (next.equals("--start")) {
                start = true;
                rest.remove();
            } else if (next.equals("--name")) {
                rest.remove();
                if (!rest.hasNext()) {
                    throw new IllegalArgumentException("--name needs a name, as in --name lamp");
                }
                name = rest.next();
                rest.remove();
            }
        }
        return new ServiceOptions(start, name);
    }
}
