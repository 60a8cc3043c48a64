package org.evoloop.roomba;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.Collections;
import java.util.List;
import org.evoloop.config.ConfigException;
import org.evoloop.config.Settings;
import org.evoloop.config.UsersMistakes;
import org.evoloop.journal.JournalException;
import org.evoloop.link.LinkException;
import org.evoloop.link.SerialLink;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.tool.CalibrateCommand;
import org.evoloop.roomba.camera.tool.CameraCommand;
import org.evoloop.roomba.camera.tool.MarkerCommand;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.simulator.SimulatorCommand;
import org.evoloop.service.Ctl;
import org.evoloop.service.ErrorOutput;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFile;
import picocli.CommandLine;

/** Runs the command line; a usage error prints one line and exits with status 2. */
public final class Main {
    private static final List<String> HELP = List.of("-h", "--help", "-V", "--version");

    private Main() {}

    public static void main(String[] arguments) {
        System.exit(run(arguments));
    }

    /**
     * Runs the command line and returns the exit status: 0 for success, 1 if a check failed, 2 for wrong usage or
     * input.
     */
    static int run(String... arguments) {
        if (arguments.length > 0 && arguments[0].equals("ctl")) {
            // Ctl needs none of the slow-loading parts; its options are those of the commands that it passes on.
            return Ctl.run(List.of(arguments).subList(1, arguments.length));
        }
        boolean plain = arguments.length == 0 || arguments[0].startsWith("-");
        return plain && Collections.disjoint(List.of(arguments), HELP)
                ? converterAlone(arguments)
                : UsersMistakes.execute(everything(), arguments);
    }

    /**
     * Parses the converter's options only. Finding the options of all commands takes longer than starting a converter;
     * they are tried if these do not match the arguments.
     */
    private static int converterAlone(String... arguments) {
        Thread loading = new Thread(Main::loadSlowParts, "roomba-loading");
        loading.setDaemon(true);
        loading.start();
        RoombaCommand command = new RoombaCommand();
        CommandLine line = withHandlers(RoombaCommand.line(command));
        Settings settings;
        try {
            settings = command.configure(line, List.of(arguments));
        } catch (ConfigException mistakes) {
            if (namesACommand(arguments)) {
                return UsersMistakes.execute(everything(), arguments);
            }
            line.getErr().println("error: " + mistakes.getMessage());
            return CommandLine.ExitCode.USAGE;
        }
        return settings.answer(System.out, System.err)
                .orElseGet(() -> line.execute(settings.asArguments().toArray(String[]::new)));
    }

    private static boolean namesACommand(String... arguments) {
        CommandLine all = everything();
        all.getCommandSpec().parser().collectErrors(true);
        return all.parseArgs(arguments).hasSubcommand();
    }

    /** Runs in parallel with parsing the options, which takes about as long. */
    private static void loadSlowParts() {
        ModelFile.prepare();
        try {
            SerialLink.prepare();
        } catch (LinkException | ExceptionInInitializerError reportedWhenALinkIsOpened) {
            // A failure is reported when the library is used; a program that only prints and exits does not use it.
        }
    }

    private static CommandLine everything() {
        return withHandlers(RoombaCommand.line(new RoombaCommand())
                .addSubcommand(new EdgeCommand())
                .addSubcommand(new SimulatorCommand())
                .addSubcommand(new DemoCommand())
                .addSubcommand(new CameraCommand())
                .addSubcommand(new MarkerCommand())
                .addSubcommand(new CalibrateCommand()));
    }

    private static CommandLine withHandlers(CommandLine commandLine) {
        commandLine.setErr(new PrintWriter(ErrorOutput.stream(), true, Charset.defaultCharset()));
        return UsersMistakes.reportedBy(commandLine.setCaseInsensitiveEnumValuesAllowed(true), Main::isUsersMistake);
    }

    /** Whether the user of the program can fix it. */
    static boolean isUsersMistake(Exception failure) {
        return failure instanceof ModelException
                || failure instanceof LinkException
                || failure instanceof RobotException
                || failure instanceof CameraException
                || failure instanceof JournalException
                || failure instanceof IllegalArgumentException
                || failure instanceof IOException;
    }
}
