package org.evoloop.models.device;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.console.Console;
import org.evoloop.statemachine.Names;
import org.evoloop.xmi.ModelFiles;
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
    /** The kinds of connections, each with its usual address. */
    private static final Map<String, String> ADDRESSES = new TreeMap<>(
            Map.of("lines", "tcp://127.0.0.1:4001", "mqtt", "mqtt://localhost", "http", "http://localhost:8080"));

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "NAME", description = "The folder, whose name is also the device's.")
    private Path folder;

    @Option(
            names = "--connection",
            paramLabel = "KIND",
            description = "How the device is connected: lines, which is text over TCP (default), mqtt or http.")
    private @Nullable String connection;

    @Option(
            names = "--address",
            paramLabel = "ADDRESS",
            description = "Where: tcp://HOST:PORT, mqtt://HOST or http://HOST.")
    private @Nullable String address;

    @Option(
            names = "--events",
            paramLabel = "EVENT,...",
            split = ",",
            description = "The events that the device takes; the first switches it on and off (default: power).")
    private @Nullable List<String> events;

    @Option(
            names = "--from",
            paramLabel = "DEVICE",
            description = "Copies one of the devices that come with Evoloop, such as fan.")
    private @Nullable String from;

    @Override
    public Integer call() throws IOException {
        String name = String.valueOf(folder.getFileName());
        require(
                name.matches("[A-Za-z0-9][A-Za-z0-9._-]*"),
                "'" + name + "' is no name for a folder; use letters, digits and -");
        if (Files.exists(folder)) {
            throw new FileAlreadyExistsException(folder + " exists already; give another name");
        }
        if (from == null) {
            ask(name);
        } else {
            require(
                    connection == null && address == null && events == null,
                    "--from copies what is there; leave --connection, --address and --events out");
            copy(from, name);
        }
        spec.commandLine()
                .getOut()
                .println("wrote " + folder.resolve(name + ".yaml") + " and " + folder.resolve("README.md"));
        spec.commandLine()
                .getErr()
                .println("next: evoloop check " + folder.resolve(name + ".yaml") + ", then evoloop run "
                        + folder.resolve(name + ".yaml") + " --simulate");
        return 0;
    }

    private void ask(String name) throws IOException {
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
        Files.createDirectory(folder);
        Files.writeString(folder.resolve(name + ".yaml"), file(name, kind, at, taken));
        Files.writeString(folder.resolve("README.md"), drawings(name, taken));
    }

    /** Copies the folder of a device; its commands name the new folder then, and its links still lead where they led. */
    private void copy(String device, String name) throws IOException {
        Path devices = ModelFiles.find("devices/fan/fan.yaml", NewCommand.class)
                .resolveSibling("..")
                .normalize();
        List<String> names = listed(devices, Files::isDirectory).stream()
                .map(path -> path.getFileName().toString())
                .toList();
        require(names.contains(device), "there is no device '" + device + "'" + Names.hint(device, names));
        List<Path> files = listed(devices.resolve(device), Files::isRegularFile);
        Files.createDirectory(folder);
        String toDevices = folder.toAbsolutePath().normalize().relativize(devices.toAbsolutePath()) + "/";
        for (Path file : files) {
            boolean isDeviceFile = file.endsWith(device + ".yaml");
            String text = Files.readString(file)
                    .replace("devices/" + device + "/" + device + ".yaml", folder + "/" + name + ".yaml")
                    .replace("devices/" + device + "/", folder + "/")
                    .replaceAll("(?<=\\(|: )\\.\\./", Matcher.quoteReplacement(toDevices));
            Files.writeString(
                    folder.resolve(
                            isDeviceFile ? name + ".yaml" : file.getFileName().toString()),
                    isDeviceFile ? text.replaceFirst("(?m)^converter: .*$", "converter: " + name) : text);
        }
    }

    private static List<Path> listed(Path folder, Predicate<Path> wanted) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(wanted).sorted().toList();
        }
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

    private static String file(String name, String kind, String at, List<String> taken) {
        String first = taken.get(0);
        return """
                # What %1$s is, and how it is connected. evoloop check %1$s.yaml checks it without the device.
                converter: %1$s
                models: {original: README.md#original, new: README.md#new}

                connections:
                %2$s

                device:
                  send:                    # what is sent for each event
                %3$s

                controller:
                  press:                   # what tells that a control was operated
                %4$s

                scenarios:
                  after ten minutes it is switched off:
                    - {press: timed, sent: [%5$s], state: Timed}
                    - {after: 10 min, sent: [%5$s], state: "Off"}
                """.formatted(name, connections(name, kind, at), sent(kind, taken), pressed(name, kind, taken), first);
    }

    private static String connections(String name, String kind, String at) {
        return switch (kind) {
            case "mqtt" -> "  device: {mqtt: \"" + at + "\", command-topic: " + name + "/set}";
            case "http" -> "  device: {http: \"" + at + "\"}\n  buttons: {webhooks: 8088}";
            default -> "  device: {lines: \"" + at + "\"}";
        };
    }

    private static String sent(String kind, List<String> taken) {
        return indented(taken.stream()
                .map(event -> event + ": "
                        + (kind.equals("http")
                                ? "{to: device, call: POST /" + event + "}"
                                : event.toUpperCase(Locale.ROOT))));
    }

    private static String pressed(String name, String kind, List<String> taken) {
        Stream<String> all = Stream.concat(taken.stream(), Stream.of("timed"));
        return switch (kind) {
            case "mqtt" ->
                indented(Stream.of("topic: " + name + "/button", "values:")) + "\n"
                        + indented(all.map(event -> "  " + event + ": " + event));
            case "http" ->
                indented(Stream.of("from: buttons", "values:")) + "\n"
                        + indented(all.map(event -> "  POST /" + event + ": " + event));
            default -> indented(all.map(event -> "button " + event + ": " + event));
        };
    }

    private static String indented(Stream<String> lines) {
        return lines.map(line -> "    " + line).collect(Collectors.joining("\n"));
    }

    private static String drawings(String name, List<String> taken) {
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
