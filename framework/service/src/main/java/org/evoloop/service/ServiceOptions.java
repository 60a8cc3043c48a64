package org.evoloop.service;

import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How a program runs by itself.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class ServiceOptions {
    /** The names of the options, as they stand in a usage line. */
    public static final String USAGE = "[--start] [--name NAME] [--journal DIR] [--mqtt URL]";

    private final boolean start;
    private final @Nullable String name;
    private final @Nullable Path journal;
    private final @Nullable String mqtt;

    private ServiceOptions(boolean start, @Nullable String name, @Nullable Path journal, @Nullable String mqtt) {
        this.start = start;
        this.name = name;
        this.journal = journal;
        this.mqtt = mqtt;
    }

    /** An ordinary program with a console: nothing starts by itself, nothing listens or connects, and nothing is kept. */
    public static ServiceOptions none() {
        return new ServiceOptions(false, null, null, null);
    }

    /** The same for a program that opens its loop at once, and goes on when its standard input ends. */
    public ServiceOptions withStart() {
        return new ServiceOptions(true, name, journal, mqtt);
    }

    /**
     * The same for a program that {@code ctl} reaches under this name.
     *
     * @throws IllegalArgumentException if it is not a name
     */
    public ServiceOptions withName(String instance) {
        Instances.requireName(instance);
        return new ServiceOptions(start, instance, journal, mqtt);
    }

    /** The same for a program whose converter keeps its journal in this directory. */
    public ServiceOptions withJournal(Path directory) {
        return new ServiceOptions(start, name, directory, mqtt);
    }

    /** The same for a program whose converter is shown and operated through the MQTT broker of this URL. */
    public ServiceOptions withMqtt(String url) {
        return new ServiceOptions(start, name, journal, url);
    }

    /** Whether the loop is opened at once, and the end of the standard input ends nothing. */
    public boolean start() {
        return start;
    }

    /** The name under which {@code ctl} reaches it; null if it has no control socket. */
    public @Nullable String name() {
        return name;
    }

    /** The directory in which its converter keeps its journal; null if it keeps none. */
    public @Nullable Path journal() {
        return journal;
    }

    /** The URL of the MQTT broker through which its converter is shown and operated; null if it connects to none. */
    public @Nullable String mqtt() {
        return mqtt;
    }

    /**
     * Takes {@code --start}, {@code --name NAME}, {@code --journal DIR} and {@code --mqtt URL} out of a command line.
     *
     * @param arguments a list that can be changed; what is left is the program's own
     * @throws IllegalArgumentException if the name, the directory or the URL is missing, or the name is not one
     */
    public static ServiceOptions takeFrom(List<String> arguments) {
        ServiceOptions taken = none();
        for (Iterator<String> rest = arguments.iterator(); rest.hasNext(); ) {
            String next = rest.next();
            if (next.equals("--start")) {
                taken = taken.withStart();
                rest.remove();
            } else if (next.equals("--name")) {
                taken = taken.withName(value(rest, "--name needs a name, as in --name lamp"));
            } else if (next.equals("--journal")) {
                taken = taken.withJournal(
                        Path.of(value(rest, "--journal needs a directory, as in --journal /var/lib/lamp")));
            } else if (next.equals("--mqtt")) {
                taken = taken.withMqtt(value(rest, "--mqtt needs a broker, as in --mqtt mqtt://ha@broker"));
            }
        }
        return taken;
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
