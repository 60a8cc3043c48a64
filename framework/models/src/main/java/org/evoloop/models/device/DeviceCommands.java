package org.evoloop.models.device;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToIntFunction;
import org.evoloop.config.ConfigException;
import org.evoloop.config.UsersMistakes;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.service.ErrorOutput;
import org.evoloop.statemachine.ModelException;
import picocli.CommandLine;

/** The commands for device files: {@code run}, {@code check} and {@code new}. */
public final class DeviceCommands {
    private static final String USAGE = """
            usage: evoloop run FILE.yaml [OPTIONS]
                   evoloop check FILE.yaml
                   evoloop new NAME [OPTIONS]

              run     runs the converter of a device file; --simulate plays the device (run --help for all options)
              check   checks the file, its models and its scenarios, without the device
              new     writes a device file to begin with (new --help for all options)

            Exit status: 0 success, 1 a check or the program failed, 2 wrong usage or input.
            """;

    private DeviceCommands() {}

    /**
     * Runs a command.
     *
     * @param models runs a command for models, and returns its exit status
     * @return the exit status: 0 success, 1 a check or the program failed, 2 wrong usage or input
     */
    public static int run(List<String> arguments, ToIntFunction<List<String>> models) {
        try {
            String command = arguments.isEmpty() ? "" : arguments.get(0);
            List<String> rest = arguments.isEmpty() ? List.of() : arguments.subList(1, arguments.size());
            boolean isFile = !rest.isEmpty() && !rest.get(0).startsWith("-");
            if (command.equals("run") && rest.equals(List.of("--help"))) {
                return DeviceProgram.help();
            }
            if (command.equals("new")) {
                return UsersMistakes.execute(
                        UsersMistakes.reportedBy(new CommandLine(new NewCommand()), IOException.class::isInstance),
                        rest.toArray(String[]::new));
            }
            if (arguments.contains("--help")) {
                System.out.print(USAGE);
                return 0;
            }
            if (command.equals("run") && isFile) {
                return DeviceProgram.run(Path.of(rest.get(0)), rest.subList(1, rest.size()));
            }
            if (command.equals("check") && isFile && rest.size() == 1) {
                return DeviceCheck.run(Path.of(rest.get(0)), System.out, models);
            }
            System.err.print(USAGE);
            return 2;
        } catch (DeviceFileException | ModelException | ConfigException refused) {
            ErrorOutput.stream()
                    .println(Arrays.stream(String.valueOf(refused.getMessage()).split("\n", -1))
                            .reduce("", (all, line) -> all + (all.isEmpty() ? "error: " : "\nerror: ") + line));
            return 2;
        }
    }
}
