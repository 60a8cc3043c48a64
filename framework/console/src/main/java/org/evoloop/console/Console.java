package org.evoloop.console;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.URI;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.evoloop.converter.SystemEventConverter;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Controls a converter by lines of text: {@code start}, {@code stop}, {@code status}, {@code watch}, {@code list},
 * {@code exchange}, {@code history}, {@code help}, {@code exit}, and the commands that the application adds.
 *
 * <p>A terminal first shows the system's states and what can be typed next; it has line editing, completion and
 * history, provided that JLine is on the class path. From a pipe each line is a command, without prompt and echo.
 * Results go to the output; a command that fails prints one line {@code error: ...} to the error output, and the
 * console continues.
 *
 * <p>Lifecycle: {@link #run} reads commands until {@code exit}, the end of the input, Ctrl-C on an empty line, one of
 * the signals TERM and HUP, an interrupt of its thread, or {@link #end}, then closes the converter and leaves terminal
 * and signals as it found them. A console that {@link #outliveInput outlives its input} ends neither at the end of the
 * input nor by HUP.
 *
 * <p>Threading: put together and run by one thread, which may be interrupted from any; {@link #perform} and {@link
 * #end} may be called from any thread. The application's commands run one at a time; the console's own do not wait for
 * them.
 *
 * @since 0.1
 */
public final class Console {
    private static final Logger LOG = LoggerFactory.getLogger(Console.class);

    private final SystemEventConverter converter;
    private final Deque<SystemEventConverter> others = new ArrayDeque<>();
    private final InputStream in;
    private final PrintStream out;
    private final PrintStream err;
    private final CommandSet commands = new CommandSet();

    /** The terminal while a thread uses one, else null. */
    private volatile @Nullable Person person;

    private final List<ConsoleCommand> added = new CopyOnWriteArrayList<>();
    private final ReentrantLock turn = new ReentrantLock(true);
    private final List<Runnable> beginListeners = new ArrayList<>();
    private final List<Consumer<String>> endListeners = new ArrayList<>();
    private final Ending ending = new Ending();
    private boolean outlivesInput;
    private @Nullable OfferedModels offeredModels;
    private volatile @Nullable URI page;

    private final Reader reader = new Reader() {
        @Override
        public boolean isAtTerminal() {
            return terminal() != null;
        }

        @Override
        public void watch(Supplier<String> text, Duration period) throws InterruptedException {
            ConsoleIo io = terminal();
            if (io == null) {
                throw new IllegalStateException("watch needs a terminal; status prints the same once");
            }
            io.watch(text, period);
        }

        private @Nullable ConsoleIo terminal() {
            Person here = person;
            return here == null || here.thread() != Thread.currentThread() ? null : here.terminal();
        }
    };

    private record Person(Thread thread, ConsoleIo terminal) {}

    /**
     * @param converter built; the console closes it
     * @param in the source of commands; a terminal only if this is {@code System.in} and {@code out} is {@code
     *     System.out}
     * @param out for results
     * @param err for errors
     */
    public Console(SystemEventConverter converter, InputStream in, PrintStream out, PrintStream err) {
        this.converter = converter;
        this.in = in;
        this.out = out;
        this.err = err;
        ConverterCommands.addTo(commands, converter, reader, () -> NextStep.after(converter, "", added));
        commands.add(ConsoleCommand.of(
                "exit",
                "ends the program; so do Ctrl-C on an empty line, and the end of the input unless it was started with --start",
                (arguments, ignored) -> ending.ask("exit", 0)));
    }

    /**
     * Adds another converter to this console, before {@link #run}: its commands follow its name, as in {@code door
     * status}. The console closes the converters in reverse order.
     *
     * @param other built
     * @throws IllegalArgumentException if there is a command with its name
     */
    public void addConverter(SystemEventConverter other) {
        String name = other.status().name();
        CommandSet own = new CommandSet();
        ConverterCommands.addTo(own, other, reader, () -> NextStep.after(other, name + " ", List.of()));
        commands.add(ConsoleCommand.of(
                        name + " COMMAND [ARGUMENT] [ARGUMENT]",
                        "controls the converter " + name + ": " + String.join(", ", own.names()),
                        (words, results) -> own.perform(words, results, false))
                .completing(own::completions));
        others.push(other);
    }

    /**
     * Adds the commands {@code evolve} and {@code rollback}, before {@link #run}, for a converter that can make
     * {@linkplain SystemEventConverter#addKnowledgeFactory knowledge} of other models.
     *
     * @param models reads the models that these commands name
     */
    public void evolvesBy(NewModels models) {
        OfferedModels offered = new OfferedModels(converter, models);
        offeredModels = offered;
        EvolveCommands.of(converter, models, offered).forEach(commands::add);
    }

    /** Sets the address of the converter's page in the browser. */
    public void shownAt(URI address) {
        page = address;
    }

    /** The address of the converter's page in the browser; empty if it has none. */
    public Optional<URI> page() {
        return Optional.ofNullable(page);
    }

    /** The models that {@code evolve} offers; empty if there is no such command. */
    public Optional<OfferedModels> offeredModels() {
        return Optional.ofNullable(offeredModels);
    }

    /**
     * Adds a command, before {@link #run}.
     *
     * @throws IllegalArgumentException if there is one of that name
     */
    public void addCommand(ConsoleCommand command) {
        ConsoleCommand.Action action = command.action() instanceof PressAction
                ? command.action()
                : (arguments, results) -> inTurn(command, arguments, results);
        commands.add(
                new ConsoleCommand(command.usage(), command.help(), action, command.completion(), command.offered()));
        added.add(command);
    }

    /** The commands that the application has added, in their order; they are performed by {@link #perform}. */
    public List<ConsoleCommand> addedCommands() {
        return List.copyOf(added);
    }

    private void inTurn(ConsoleCommand command, List<String> arguments, PrintStream results) throws Exception {
        turn.lockInterruptibly();
        try {
            command.action().run(arguments, results);
        } finally {
            turn.unlock();
        }
    }

    /**
     * Calls {@code listener} when the run begins, before the first command is read: from then on signals end the run, after
     * the listener has returned.
     */
    public void onBegin(Runnable listener) {
        beginListeners.add(listener);
    }

    /** Calls {@code listener} with the reason when the run is about to end, before the converters are closed. */
    public void onEnd(Consumer<String> listener) {
        endListeners.add(listener);
    }

    /**
     * Makes {@link #run} continue after the end of the input, or when that cannot be read, until it is ended otherwise; to
     * be called before it.
     */
    public void outliveInput() {
        outlivesInput = true;
    }

    /** The converters of this console, in the order in which they were added. */
    public List<SystemEventConverter> converters() {
        List<SystemEventConverter> all = new ArrayList<>(others);
        all.add(converter);
        Collections.reverse(all);
        return all;
    }

    /**
     * Ends {@link #run}, or makes it return at once if it is called later. Only the first reason counts.
     *
     * @param reason for the program's operator, such as {@code SIGTERM}
     * @param status the return value of {@link #run}
     */
    public void end(String reason, int status) {
        ending.ask(reason, status);
    }

    /** Whether it has been asked to end. */
    public boolean isEnding() {
        return ending.isAsked();
    }

    /**
     * Reads and performs commands until the end.
     *
     * @return the exit status for the process: 0, 1 if the input could not be read, or the status given to {@link #end}
     */
    public int run() {
        try (ConsoleIo io = open(() -> ending.ask("Ctrl-C", 0))) {
            // Registered after the terminal, which has signal handlers of its own and must restore them last.
            TerminationSignals signals = new TerminationSignals(this::signalled);
            try {
                return run(io);
            } finally {
                signals.restore();
            }
        }
    }

    private void signalled(String name) {
        // Closing the terminal must not end a program that does not need it.
        if (!(outlivesInput && name.equals("HUP"))) {
            ending.ask("SIG" + name, 0);
        }
    }

    /**
     * Performs one command, on the caller's thread.
     *
     * @param line the command as typed
     * @param results receives its results
     * @param errors receives the line that begins with {@code error:}
     * @return 0, 1 if the command failed, 2 if there is no such command or it takes other arguments
     * @throws InterruptedException if the thread was interrupted
     */
    public int perform(String line, PrintStream results, PrintStream errors) throws InterruptedException {
        return perform(line, results, errors, false);
    }

    /** As {@link #perform}, for somebody who wants to know the outcome of a press: that is waited for. */
    public int performAndWait(String line, PrintStream results, PrintStream errors) throws InterruptedException {
        return perform(line, results, errors, true);
    }

    private int perform(String line, PrintStream results, PrintStream errors, boolean waiting)
            throws InterruptedException {
        try {
            commands.perform(line, results, waiting);
            return 0;
        } catch (InterruptedException stop) {
            throw stop;
        } catch (Exception failure) {
            LOG.debug("'{}' failed", line, failure);
            errors.println("error: " + message(failure));
            return failure instanceof IllegalArgumentException ? 2 : 1;
        } catch (Error bug) {
            // A faulty command must not end the program.
            LOG.error("the command '{}' failed", line, bug);
            errors.println("error: " + bug);
            return 1;
        } finally {
            results.flush();
        }
    }

    /** Whether this process shows its output on a terminal that can move its cursor and show colours. */
    @SuppressWarnings("SystemConsoleNull") // never null since JDK 22, which has isTerminal instead
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
        InputStream lines = in == System.in && !StandardInput.isThere() ? InputStream.nullInputStream() : in;
        return terminal == null ? new StreamIo(lines, out, err) : terminal;
    }

    /** Converses through {@code io}, then closes the converter. */
    int run(ConsoleIo io) {
        try {
            // Before a request to end can interrupt this thread, since an interrupt would leave a listener's work half
            // done.
            beginListeners.forEach(Runnable::run);
            ending.begin();
            if (io.isTerminal()) {
                io.out().print(ConverterCommands.text(text -> FirstScreen.show(converters(), added, text)));
                person = new Person(Thread.currentThread(), io);
            }
            converse(io);
        } finally {
            person = null;
            ending.over();
            endListeners.forEach(listener -> listener.accept(ending.reason()));
            others.forEach(SystemEventConverter::close);
            converter.close();
        }
        return ending.status();
    }

    private void converse(ConsoleIo io) {
        try {
            performAll(io);
            if (outlivesInput) {
                ending.await();
            }
            ending.ask("the end of the input", 0);
        } catch (InterruptedException end) {
            ending.ask("an interrupt", 0);
        }
    }

    /** Performs the commands of the input until it ends or the program shall end. */
    private void performAll(ConsoleIo io) throws InterruptedException {
        try {
            for (String line = io.readLine(); line != null; line = io.readLine()) {
                perform(line, io.out(), io.err());
                if (ending.isAsked()) {
                    return;
                }
            }
        } catch (IOException failure) {
            io.err().println("error: " + failure.getMessage());
            if (!outlivesInput) {
                ending.ask("the input cannot be read", 1);
            }
        }
    }

    private static String message(Exception failure) {
        @Nullable String message = failure.getMessage();
        return message == null ? failure.getClass().getSimpleName() : message;
    }
}
