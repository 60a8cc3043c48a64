package org.evoloop.console;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.util.ArrayDeque;
import java.util.Deque;
import org.evoloop.converter.SystemEventConverter;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Controls a converter by lines of text: {@code start}, {@code stop}, {@code status}, {@code list}, {@code exchange},
 * {@code history}, {@code help}, {@code exit}, and the commands that the application adds.
 *
 * <p>On a terminal lines are edited, completed and remembered, provided that JLine is on the class path. From a pipe each
 * line is a command, without prompt and echo. Results go to the output; a command that fails prints one line {@code error:
 * ...} to the error output, and the console goes on.
 *
 * <p>Lifecycle: {@link #run} reads commands until {@code exit}, the end of the input, Ctrl-C, one of the signals TERM and
 * HUP, or an interrupt of its thread, then closes the converter and leaves terminal and signals as it found them.
 *
 * <p>Threading: not thread-safe; {@link #run} may be interrupted from any thread.
 */
public final class Console {
    private static final Logger LOG = LoggerFactory.getLogger(Console.class);

    private final SystemEventConverter converter;
    private final Deque<SystemEventConverter> others = new ArrayDeque<>();
    private final InputStream in;
    private final PrintStream out;
    private final PrintStream err;
    private final CommandSet commands = new CommandSet();
    private volatile boolean ending;

    /**
     * @param converter built; the console closes it
     * @param in where commands come from; a terminal only if this is {@code System.in} and {@code out} is {@code
     *     System.out}
     * @param out for results
     * @param err for errors
     */
    public Console(SystemEventConverter converter, InputStream in, PrintStream out, PrintStream err) {
        this.converter = converter;
        this.in = in;
        this.out = out;
        this.err = err;
        ConverterCommands.addTo(commands, converter);
        commands.add(ConsoleCommand.of(
                "exit",
                "ends the program; so do Ctrl-C, Ctrl-D and the end of the input",
                (arguments, ignored) -> ending = true));
    }

    /**
     * Puts another converter under this console, before {@link #run}: its commands follow its name, as in {@code door
     * status}. The console closes it, the one that was added last first.
     *
     * @param other built
     * @throws IllegalArgumentException if there is a command of its name
     */
    public void addConverter(SystemEventConverter other) {
        String name = other.status().name();
        CommandSet own = new CommandSet();
        ConverterCommands.addTo(own, other);
        commands.add(ConsoleCommand.of(
                        name + " COMMAND [ARGUMENT] [ARGUMENT]",
                        "controls the converter " + name + ": " + String.join(", ", own.names()),
                        own::perform)
                .completing(own::completions));
        others.push(other);
    }

    /** Adds a command, before {@link #run}. @throws IllegalArgumentException if there is one of that name */
    public void addCommand(ConsoleCommand command) {
        commands.add(command);
    }

    /**
     * Reads and performs commands until the end.
     *
     * @return the exit status for the process: 0, or 1 if the input could not be read
     */
    public int run() {
        Thread own = Thread.currentThread();
        Runnable end = () -> {
            ending = true;
            own.interrupt();
        };
        try (ConsoleIo io = open(end)) {
            // After the terminal, which has signal handlers of its own and must give them back last.
            TerminationSignals signals = new TerminationSignals(end);
            try {
                return run(io);
            } finally {
                signals.restore();
            }
        } finally {
            // A signal that asked for the end has been answered.
            Thread.interrupted();
        }
    }

    /** Whether this process shows its output on a terminal that can move its cursor and show colours. */
    @SuppressWarnings("SystemConsoleNull") // since JDK 22 never null, but from then on it can be asked
    public static boolean isOnTerminal() {
        java.io.Console console = System.console();
        if (console == null || "dumb".equals(System.getenv("TERM"))) {
            return false;
        }
        try {
            return (boolean) java.io.Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException beforeJdk22) {
            return true;
        }
    }

    private ConsoleIo open(Runnable end) {
        ConsoleIo terminal = null;
        if (in == System.in && out == System.out && isOnTerminal()) {
            try {
                terminal = TerminalIo.open(commands::completions, end);
            } catch (NoClassDefFoundError noJLine) {
                LOG.debug("lines cannot be edited without JLine", noJLine);
            }
        }
        return terminal == null ? new StreamIo(in, out, err) : terminal;
    }

    /** Converses through {@code io}, then closes the converter. */
    int run(ConsoleIo io) {
        try {
            if (io.isTerminal()) {
                io.out().println(converter.status().name() + ": type help to see the commands");
            }
            return converse(io);
        } finally {
            others.forEach(SystemEventConverter::close);
            converter.close();
        }
    }

    private int converse(ConsoleIo io) {
        try {
            String line = io.readLine();
            while (line != null && !perform(line, io)) {
                line = io.readLine();
            }
            return 0;
        } catch (InterruptedException end) {
            return 0;
        } catch (IOException failure) {
            io.err().println("error: " + failure.getMessage());
            return 1;
        }
    }

    /** Performs one command; true if it is the last. */
    private boolean perform(String line, ConsoleIo io) throws InterruptedException {
        try {
            commands.perform(line, io.out());
        } catch (InterruptedException end) {
            throw end;
        } catch (Exception failure) {
            LOG.debug("'{}' failed", line, failure);
            io.err().println("error: " + message(failure));
        }
        io.out().flush();
        return ending;
    }

    private static String message(Exception failure) {
        @Nullable String message = failure.getMessage();
        return message == null ? failure.getClass().getSimpleName() : message;
    }
}
