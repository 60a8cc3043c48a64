package org.evoloop.service;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
              ctl lamp watch           # on a terminal: shows the status every second
              ctl lamp help            # lists its commands
              ctl                      # lists the instances that run

            Exit status: 0 success, 1 the command failed, 2 wrong usage, or no such instance.
            """;

    /** {@code watch [SECONDS]}; other forms are left to the instance, which refuses them. */
    private static final String WATCH = "watch( [1-9][0-9]{0,3})?";

    private final Instances instances;
    private final PrintStream out;
    private final PrintStream err;

    private final boolean onTerminal;

    /** @param onTerminal whether {@code out} is a terminal */
    Ctl(Instances instances, PrintStream out, PrintStream err, boolean onTerminal) {
        this.instances = instances;
        this.out = out;
        this.err = err;
        this.onTerminal = onTerminal;
    }

    /** Runs the client, and ends the program with its exit status. */
    public static void main(String[] arguments) {
        System.exit(run(List.of(arguments)));
    }

    /** Runs the client. @return the exit status */
    public static int run(List<String> arguments) {
        return new Ctl(new Instances(System.getenv()), System.out, System.err, Console.isOnTerminal()).call(arguments);
    }

    int call(List<String> arguments) {
        if (arguments.isEmpty()) {
            running().keySet().forEach(out::println);
            instances.hidden().forEach(directory -> err.println(ofOthers(directory)));
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
        String line = words.stream()
                .map(word ->
                        word.matches("[^\\s'\"]+") ? word : word.contains("'") ? '"' + word + '"' : "'" + word + "'")
                .collect(Collectors.joining(" "));
        if (line.contains("\n") || line.contains("\r")) {
            throw new IllegalArgumentException("a command is one line");
        }
        // The instance would hang up before it has read all, and its answer could be lost with the rest.
        if (line.getBytes(StandardCharsets.UTF_8).length >= Connection.LONGEST_LINE) {
            throw new IllegalArgumentException(
                    "the command is longer than " + (Connection.LONGEST_LINE - 1) + " bytes");
        }
        return line;
    }

    private Map<String, Path> running() {
        Map<String, Path> found = new LinkedHashMap<>();
        for (Path socket : instances.sockets()) {
            if (answers(socket)) {
                found.putIfAbsent(Instances.nameOf(socket), socket);
            }
        }
        return found;
    }

    private String missing(String name, Map<String, Path> running) {
        String others = instances.hidden().stream()
                .map(directory -> "; " + ofOthers(directory))
                .collect(Collectors.joining());
        String none = others.isEmpty() ? "; none is" : " for this user";
        return "no instance named " + name + " is running"
                + (running.isEmpty() ? none : Names.hint(name, running.keySet())) + others;
    }

    private static String ofOthers(Path directory) {
        return "the instances in " + directory + " belong to another user; use sudo to see them";
    }

    private static boolean answers(Path socket) {
        try {
            connect(socket).close();
            return true;
        } catch (IOException leftByOneThatDied) {
            return false;
        }
    }

    private static SocketChannel connect(Path socket) throws IOException {
        SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX);
        try {
            channel.connect(UnixDomainSocketAddress.of(socket));
            return channel;
        } catch (IOException failure) {
            channel.close();
            throw failure;
        }
    }

    private int command(String name, String line, PrintStream results) throws IOException {
        Map<String, Path> running = running();
        Path socket = running.get(name);
        if (socket == null) {
            throw new IllegalArgumentException(missing(name, running));
        }
        try (SocketChannel channel = connect(socket)) {
            ByteBuffer request = StandardCharsets.UTF_8.encode(line + "\n");
            while (request.hasRemaining()) {
                channel.write(request);
            }
            // Announces that no request follows: the instance then closes the connection after its answer, or when it
            // has ended.
            channel.shutdownOutput();
            return show(new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)), results);
        }
    }

    private int show(BufferedReader answer, PrintStream results) throws IOException {
        int status = -1;
        for (String line = answer.readLine(); line != null; line = answer.readLine()) {
            if (line.startsWith(Reply.OUT)) {
                results.println(line.substring(Reply.OUT.length()));
            } else if (line.startsWith(Reply.ERR)) {
                err.println(line.substring(Reply.ERR.length()));
            } else if (line.startsWith(Reply.END)) {
                status = Integer.parseInt(line.substring(Reply.END.length()));
            }
        }
        if (status < 0) {
            throw new IOException("it has closed the connection");
        }
        return status;
    }
}
