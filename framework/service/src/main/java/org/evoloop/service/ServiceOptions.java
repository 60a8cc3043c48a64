package org.evoloop.service;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.jspecify.annotations.Nullable;

/**
 * The options of an unattended program.
 *
 * <p>Threading: immutable.
 *
 * @param start whether the loop is opened at once, and the end of standard input is ignored
 * @param name the name under which {@code ctl} reaches it; null if it has no control socket
 * @param journal the directory in which its converter keeps its journal; null if it keeps none
 * @param pressAge how old a press may be when its turn comes
 * @param onTrouble the command of the POSIX shell that is run when something has gone wrong; null for none
 * @since 0.1
 */
public record ServiceOptions(
        boolean start,
        @Nullable String name,
        @Nullable Path journal,
        Duration pressAge,
        @Nullable String onTrouble) {
    private static final String USUAL_PRESS_AGE = "10";

    private static final Option<Boolean> START =
            Option.flag("start", "Starts converting at once, and keeps running when the standard input ends.");
    private static final Option<String> NAME = Option.value(
            "name", "NAME", "Takes commands for NAME: ctl NAME status (default: nothing listens).", name -> {
                Instances.requireName(name);
                return name;
            });
    private static final Option<Path> JOURNAL = Option.path(
            "journal",
            "DIR",
            "Records the converter's inputs in this directory, and resumes where the previous process ended (default: "
                    + "nothing is recorded).");

    private static final Option<Duration> PRESS_AGE = Option.value(
                    "press-age",
                    "SECONDS",
                    "How old a press may be when its turn comes; an older one, such as one from before an outage, is not "
                            + "carried out (default: " + USUAL_PRESS_AGE + ").",
                    ServiceOptions::seconds)
            .withDefault(USUAL_PRESS_AGE);

    private static final Option<String> ON_TROUBLE = Option.value(
            "on-trouble",
            "COMMAND",
            "Runs this shell command when something has gone wrong, with the words in EVOLOOP_TROUBLE (default: nothing "
                    + "is run).",
            command -> {
                if (command.isBlank()) {
                    throw new IllegalArgumentException("the command is empty; leave the option out to run nothing");
                }
                return command;
            });

    /** The options of a program. */
    public static final Options OPTIONS = Options.of(START, NAME, JOURNAL, PRESS_AGE, ON_TROUBLE)
            .checking((settings, mistakes) -> settings.get(NAME)
                    .ifPresent(name -> mistakes.tried(
                            "name",
                            IllegalArgumentException.class::isInstance,
                            () -> Instances.socket(new Instances(System.getenv()).directory(), name))));

    /**
     * Options of these values.
     *
     * @throws IllegalArgumentException if the name is not one
     */
    public ServiceOptions {
        if (name != null) {
            Instances.requireName(name);
        }
    }

    private static Duration seconds(String text) {
        double seconds = text.matches("[0-9]{1,5}([.][0-9]{1,3})?") ? Double.parseDouble(text) : 0;
        if (seconds < 0.1 || seconds > Duration.ofDays(1).toSeconds()) {
            throw new IllegalArgumentException("--press-age is " + text + ", allowed is 0.1 to 86400 seconds");
        }
        return Duration.ofMillis(Math.round(seconds * 1000));
    }

    /**
     * The options of an ordinary program with a console: no automatic start, no control socket, no journal,
     * and nothing that is run on trouble.
     */
    public static ServiceOptions none() {
        return new ServiceOptions(false, null, null, seconds(USUAL_PRESS_AGE), null);
    }

    /** The options given to a program. */
    public static ServiceOptions of(Settings settings) {
        return new ServiceOptions(
                settings.isOn(START),
                settings.get(NAME).orElse(null),
                settings.get(JOURNAL).orElse(null),
                settings.get(PRESS_AGE).orElseThrow(),
                settings.get(ON_TROUBLE).orElse(null));
    }

    /** A copy for a program that opens its loop at once, and continues when its standard input ends. */
    public ServiceOptions withStart() {
        return new ServiceOptions(true, name, journal, pressAge, onTrouble);
    }

    /**
     * A copy for a program that {@code ctl} reaches under this name.
     *
     * @throws IllegalArgumentException if it is not a name
     */
    public ServiceOptions withName(String instance) {
        return new ServiceOptions(start, instance, journal, pressAge, onTrouble);
    }
}
