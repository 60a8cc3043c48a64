package org.evoloop.service;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.console.Console;
import org.evoloop.statemachine.Names;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/**
 * {@code ctl NAME COMMAND [ARGUMENT ...]}: gives a command to a running instance; without a name, lists those that run.
 *
 * @since 0.1
 */
public final class Ctl {
    private static final String USAGE = """
            usage: ctl [NAME COMMAND [ARGUMENT ...]]

            Gives a command of the console to the running converter that was started with --name NAME, such as:

              ctl lamp status --json
              ctl lamp press party     # waits for the outcome, unless --no-wait is given
              ctl lamp watch           # on a terminal: shows the status every second
              ctl lamp help            # lists its commands
              ctl                      # lists the instances that run

            Exit status: 0 success, 1 the command failed or the event was not handled, 2 wrong usage, or no such instance.
            """;

    /** {@code watch [SECONDS]}; other forms are left to the instance, which refuses them. */
    private static final String WATCH = "watch( [1-9][0-9]{0,3})?";

    private final Instances instances;
    private final PrintStream out;
    private final PrintStream err;

    private final boolean onTerminal;
    private final Duration patience;

    /**
     * @param onTerminal whether {@code out} is a terminal
     * @param patience see {@link Instance#PATIENCE}
     */
    Ctl(Instances instances, PrintStream out, PrintStream err, boolean onTerminal, Duration patience) {
        this.instances = instances;
        this.out = out;
        this.err = err;
        this.onTerminal = onTerminal;
        this.patience = patience;
    }

    /** Runs the client, and ends the program with its exit status. */
    public static void main(String[] arguments) {
        System.exit(run(List.of(arguments)));
    }

    /**
     * Runs the client.
     *
     * @return the exit status
     */
    public static int run(List<String> arguments) {
        return new Ctl(
                        new Instances(System.getenv()),
                        System.out,
                        System.err,
                        Console.isOnTerminal(),
                        Instance.PATIENCE)
                .call(arguments);
    }

    /**
     * Runs the client for another program.
     *
     * @param out receives the answer
     * @param err receives messages
     * @return the exit status
     */
    public static int run(List<String> arguments, PrintStream out, PrintStream err) {
        return new Ctl(new Instances(System.getenv()), out, err, false, Instance.PATIENCE).call(arguments);
    }

    int call(List<String> arguments) {
        int status = answer(arguments);
        if (status == 0 && out.checkError()) {
            // A stream reports a full disk or a closed pipe only here.
            err.println("error: standard output: the answer could not be written in full");
            return 1;
        }
        return status;
    }

    private int answer(List<String> arguments) {
        if (arguments.isEmpty()) {
            running().keySet().forEach(out::println);
            instances.closedDirectories().forEach(directory -> err.println("note: " + elsewhere(directory)));
            return 0;
        }
        String name = arguments.get(0);
        if (name.equals("--help") || name.equals("-h")) {
            out.print(USAGE);
            return 0;
        }
        try {
            Instances.requireName(name);
            if (arguments.size() == 1) {
                throw new IllegalArgumentException(
                        "give a command for " + name + ": ctl " + name + " help lists its commands");
            }
            String line = line(arguments.subList(1, arguments.size()));
            return onTerminal && line.matches(WATCH) ? watch(name, line) : command(name, line, out);
        } catch (IllegalArgumentException mistake) {
            err.println("error: " + mistake.getMessage());
            return 2;
        } catch (IOException failure) {
            err.println("error: " + name + " does not answer: " + failure.getMessage());
            return 1;
        }
    }

    private int watch(String name, String line) throws IOException {
        String seconds = line.replaceAll("\\D", "");
        Duration period = Duration.ofSeconds(seconds.isEmpty() ? 1 : Integer.parseInt(seconds));
        try (Clock clock = new SystemClock()) {
            return new Watch(out, clock).run(results -> command(name, "status", results), period);
        }
    }

    /** The line to be typed at the console. */
    private static String line(List<String> words) {
        String line = words.stream().map(Ctl::quoted).collect(Collectors.joining(" "));
        if (line.contains("\n") || line.contains("\r")) {
            throw new IllegalArgumentException("a command is one line");
        }
        if (line.getBytes(StandardCharsets.UTF_8).length >= ControlConnection.LONGEST_LINE) {
            throw new IllegalArgumentException(ControlConnection.TOO_LONG);
        }
        return line;
    }

    private static String quoted(String word) {
        if (word.matches("[^\\s'\"]+")) {
            return word;
        }
        return word.contains("'") && !word.contains("\"") ? '"' + word + '"' : "'" + word.replace("'", "'\"'\"'") + "'";
    }

    private Map<String, Instance> running() {
        Map<String, Instance> found = new LinkedHashMap<>();
        for (Path socket : instances.sockets()) {
            Instance instance = new Instance(socket, patience);
            if (instance.isThere()) {
                found.putIfAbsent(Instances.nameOf(socket), instance);
            }
        }
        return found;
    }

    private int command(String name, String line, PrintStream results) throws IOException {
        Map<String, Instance> running = running();
        Instance instance = running.get(name);
        if (instance == null) {
            throw new IllegalArgumentException(missing(name, running.keySet()));
        }
        return instance.perform(line, results, err);
    }

    private String missing(String name, Set<String> running) {
        String closed = instances.closedDirectories().stream()
                .map(directory -> "; " + elsewhere(directory))
                .collect(Collectors.joining());
        String none = closed.isEmpty() ? "; none is" : " for this user";
        return "no instance named " + name + " is running" + (running.isEmpty() ? none : Names.hint(name, running))
                + closed;
    }

    private static String elsewhere(Path directory) {
        return "instances in " + directory + " can be reached only by its owner and root; try it with sudo";
    }
}
