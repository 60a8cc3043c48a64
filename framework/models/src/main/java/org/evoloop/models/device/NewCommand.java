package org.evoloop.models.device;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.console.Console;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Writes a device file with all that belongs to it, as a beginning. */
@Command(
        name = "new",
        description =
                "Writes a folder with a device file, its models as drawings in a README, and a scenario. What is not"
                        + " given is asked on a terminal.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class NewCommand implements Callable<Integer> {
    private static final Map<String, String> ADDRESSES = Map.of("lines", "tcp://127.0.0.1:4001");

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "NAME", description = "The device's name, which is also the folder's.")
    private String name;

    @Option(
            names = "--connection",
            paramLabel = "KIND",
            description = "How the device is connected: lines, text over TCP (default).")
    private @Nullable String connection;

    @Option(names = "--address", paramLabel = "ADDRESS", description = "Where: for lines, tcp://HOST:PORT.")
    private @Nullable String address;

    @Option(
            names = "--events",
            paramLabel = "EVENT,...",
            split = ",",
            description = "The events that the device takes; the first switches it on and off (default: power).")
    private @Nullable List<String> events;

    @Override
    public Integer call() throws IOException {
        require(
                name.matches("[A-Za-z0-9][A-Za-z0-9._-]*"),
                "'" + name + "' is no name for a folder; use letters, digits and -");
        String kind = asked(connection, "How is it connected? " + String.join(", ", ADDRESSES.keySet()), "lines");
        String usual = ADDRESSES.get(kind);
        require(usual != null, "--connection is '" + kind + "'; there is " + String.join(", ", ADDRESSES.keySet()));
        String at = asked(address, "At which address?", String.valueOf(usual));
        List<String> taken = Stream.of(asked(
                                events == null ? null : String.join(",", events),
                                "Which events does it take? The first switches it on and off",
                                "power")
                        .split(","))
                .map(String::strip)
                .distinct()
                .toList();
        for (String event : taken) {
            require(
                    event.matches("[A-Za-z_][A-Za-z0-9_]*"),
                    "'" + event + "' is no name of an event; use letters and digits");
        }
        Path folder = Path.of(name);
        if (Files.exists(folder)) {
            throw new FileAlreadyExistsException(folder + " exists already; give another name");
        }
        Files.createDirectory(folder);
        Files.writeString(folder.resolve(name + ".yaml"), file(kind, at, taken));
        Files.writeString(folder.resolve("README.md"), drawings(taken));
        spec.commandLine()
                .getOut()
                .println("wrote " + folder.resolve(name + ".yaml") + " and " + folder.resolve("README.md"));
        spec.commandLine()
                .getErr()
                .println("next: evoloop check " + folder.resolve(name + ".yaml") + ", then evoloop run "
                        + folder.resolve(name + ".yaml") + " --simulate");
        return 0;
    }

    private void require(boolean good, String otherwise) {
        if (!good) {
            throw new ParameterException(spec.commandLine(), otherwise);
        }
    }

    /** What was given, else the answer on a terminal, else the usual one. */
    private static String asked(@Nullable String given, String question, String usual) throws IOException {
        if (given != null || !Console.isOnTerminal()) {
            return given == null ? usual : given;
        }
        System.err.print(question + " [" + usual + "]: ");
        System.err.flush();
        String line = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8)).readLine();
        return line == null || line.isBlank() ? usual : line.strip();
    }

    private String file(String kind, String at, List<String> taken) {
        String first = taken.get(0);
        return """
                # What %1$s is, and how it is connected. evoloop check %1$s.yaml checks it without the device.
                converter: %1$s
                models: {original: README.md#original, new: README.md#new}

                connections:
                  device: {%2$s: "%3$s"}

                device:
                  send:                    # what is sent for each event
                %4$s

                controller:
                  press:                   # what a control of the controller sends here
                %5$s
                    button timed: timed

                scenarios:
                  after ten minutes it is switched off:
                    - {press: timed, sent: [%6$s], state: Timed}
                    - {after: 10 min, sent: [%6$s], state: "Off"}
                """.formatted(
                        name,
                        kind,
                        at,
                        indented(taken.stream().map(event -> event + ": " + event.toUpperCase(java.util.Locale.ROOT))),
                        indented(taken.stream().map(event -> "button " + event + ": " + event)),
                        first);
    }

    private static String indented(Stream<String> lines) {
        return lines.map(line -> "    " + line).collect(Collectors.joining("\n"));
    }

    private String drawings(List<String> taken) {
        String first = taken.get(0);
        String loops = taken.stream()
                .skip(1)
                .map(event -> "\n    On --> On : " + event)
                .collect(Collectors.joining());
        String device = "    [*] --> Off\n    Off --> On : " + first + "\n    On --> Off : " + first + loops;
        return """
                # %1$s

                ## original

                What the device does. Draw it as it is: each state that it can be in, and each event that it takes there.

                ```mermaid
                stateDiagram-v2
                %2$s
                ```

                ## new

                What it shall do. `Timed` is a new state that needs the device to be on.

                ```mermaid
                stateDiagram-v2
                %2$s
                    Off --> Timed : timed
                    On --> Timed : timed
                    Timed : «device On»
                    Timed --> Off : %3$s
                    Timed --> Off : after 10 min
                ```
                """.formatted(name, device, first);
    }
}
