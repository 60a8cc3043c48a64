package org.evoloop.models;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.config.UsersMistakes;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.journal.JournalException;
import org.evoloop.models.device.DeviceCommands;
import org.evoloop.statemachine.ModelException;
import picocli.CommandLine;

/** Runs the command line; a mistake of the user is one message and exit status 2. */
public final class Main {
    /** The property that names Logback's configuration. */
    private static final String LOG_FILE = "logback.configurationFile";

    private Main() {}

    public static void main(String[] arguments) {
        List<String> words = List.of(arguments);
        if (words.size() < 2 || !words.subList(0, 2).equals(List.of("device", "run"))) {
            beQuiet();
        }
        boolean isDevice = !words.isEmpty() && words.get(0).equals("device");
        System.exit(
                isDevice ? DeviceCommands.run(words.subList(1, words.size()), Main::onTerminal) : onTerminal(words));
    }

    /** What is only tried has no transcript; that of a converter that runs is as in every program. */
    private static void beQuiet() {
        if (System.getProperty(LOG_FILE) == null) {
            System.setProperty(LOG_FILE, "quiet.xml");
        }
    }

    private static int onTerminal(List<String> arguments) {
        String first = arguments.isEmpty() ? "" : arguments.get(0);
        CommandLine alone = switch (first) {
            case "learn" -> learning();
            case "studio" -> new CommandLine(new StudioCommand());
            default -> null;
        };
        CommandLine commandLine = alone == null ? commandLine() : alone;
        // Names may be in any script, whatever the terminal's encoding; files and pipes expect UTF-8.
        commandLine.setOut(new PrintWriter(System.out, true, StandardCharsets.UTF_8));
        commandLine.setErr(new PrintWriter(System.err, true, StandardCharsets.UTF_8));
        return run(
                commandLine,
                (alone != null ? arguments.subList(1, arguments.size()) : arguments).toArray(String[]::new));
    }

    static CommandLine learning() {
        return new CommandLine(new LearnCommand());
    }

    static CommandLine commandLine() {
        return new CommandLine(new ModelsCommand()).setCaseInsensitiveEnumValuesAllowed(true);
    }

    /**
     * Runs the command line.
     *
     * @return the exit status: 0 success, 1 a check failed or its result could not be written, 2 wrong usage or input
     */
    static int run(CommandLine commandLine, String... arguments) {
        return UsersMistakes.execute(UsersMistakes.reportedBy(commandLine, Main::isUsersMistake), arguments);
    }

    private static boolean isUsersMistake(Exception failure) {
        return failure instanceof ModelException
                || failure instanceof DeviceFileException
                || failure instanceof JournalException
                || failure instanceof IllegalArgumentException
                || failure instanceof IOException;
    }
}
