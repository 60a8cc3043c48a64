package org.evoloop.console;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.PrintStream;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jline.reader.Candidate;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.UserInterruptException;
import org.jline.terminal.Attributes;
import org.jline.terminal.Size;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import org.jline.terminal.spi.SystemStream;
import org.jline.terminal.spi.TerminalExt;
import org.jline.utils.NonBlockingReader;
import org.jspecify.annotations.Nullable;

/**
 * A terminal, with line editing, completion, and a history that lasts as long as the console.
 *
 * <p>{@code System.out}, and {@code System.err} if it shows on the terminal as well, are replaced meanwhile: output of
 * other threads appears above the line that is being edited. Lines are broken between words: results at 80 columns or
 * the terminal's width, whichever is less, others at its width.
 *
 * <p>Threading: belongs to the thread that creates it; its streams can be used by any.
 */
final class TerminalIo implements ConsoleIo {
    private static final String PROMPT = "evoloop> ";
    private static final String WATCHING = "(any key ends it)";

    private static final long KEYS_APART_MILLIS = 20;
    private static final int NARROWEST = 20;
    private static final int USUAL_HEIGHT = 24;

    private final Terminal terminal;
    private final LineReader reader;
    private final Thread conversing = Thread.currentThread();
    private final PrintStream results;
    private final PrintStream lines;
    private final PrintStream formerOut = System.out;
    private final PrintStream formerErr = System.err;

    /** Held while drawing {@link #live}. */
    private final ReentrantLock drawing = new ReentrantLock();

    private @Nullable LiveText live;

    /**
     * @param showsErrors whether the error output of this process is the same terminal
     * @param completion the words that may follow those given
     * @param interrupted what Ctrl-C does while no line is being edited
     */
    TerminalIo(
            Terminal terminal,
            boolean showsErrors,
            Function<List<String>, Collection<String>> completion,
            Runnable interrupted) {
        this.terminal = terminal;
        this.reader = LineReaderBuilder.builder()
                .terminal(terminal)
                .completer((lineReader, line, candidates) -> completion
                        .apply(line.words().subList(0, line.wordIndex()))
                        .forEach(word -> candidates.add(new Candidate(word))))
                .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
                .build();
        this.results = LineStream.printer(text -> show(text, Wrapping.USUAL_WIDTH));
        this.lines = LineStream.printer(text -> show(text, Integer.MAX_VALUE));
        terminal.handle(Terminal.Signal.INT, signal -> interrupted.run());
        System.setOut(lines);
        if (showsErrors) {
            System.setErr(lines);
        }
    }

    /** The terminal on which this process was started; null if there is none, or it cannot move its cursor. */
    static @Nullable TerminalIo open(Function<List<String>, Collection<String>> completion, Runnable interrupted) {
        try {
            // Otherwise JLine answers Ctrl-C twice, by an interrupt and by the key: the second could end the next line.
            System.setProperty(TerminalBuilder.PROP_SOFTWARE_SIGNALS, "false");
            Terminal terminal = TerminalBuilder.builder()
                    .systemOutput(TerminalBuilder.SystemOutput.SysOut)
                    .dumb(true)
                    .build();
            if (terminal.getType().startsWith(Terminal.TYPE_DUMB)) {
                terminal.close();
                return null;
            }
            if (terminal.getColumns() <= 0 || terminal.getRows() <= 0) {
                // A serial console, for example, does not know its size. JLine would not even show the prompt.
                terminal.setSize(Size.of(Wrapping.USUAL_WIDTH, USUAL_HEIGHT));
            }
            boolean showsErrors = terminal instanceof TerminalExt system
                    && system.getProvider().isSystemStream(SystemStream.Error);
            return new TerminalIo(terminal, showsErrors, completion, interrupted);
        } catch (IOException | IllegalStateException none) {
            return null;
        }
    }

    @Override
    public @Nullable String readLine() throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        while (true) {
            try {
                return reader.readLine(PROMPT);
            } catch (UserInterruptException controlC) {
                if (controlC.getPartialLine().isEmpty()) {
                    throw new InterruptedException();
                }
            } catch (EndOfFileException controlD) {
                return null;
            }
        }
    }

    /** Shows lines above what is being edited or watched. */
    private void show(String text, int longest) {
        String fitting = Wrapping.wrap(text, fit(terminal.getSize().getColumns(), longest));
        if (Thread.currentThread() == conversing) {
            // This thread is not watching, and must not wait for threads that wait for the edited line.
            reader.printAbove(fitting);
            return;
        }
        drawing.lock();
        try {
            if (live == null) {
                reader.printAbove(fitting);
            } else {
                live.above(fitting);
            }
        } finally {
            drawing.unlock();
        }
    }

    /** The longest line on a terminal of {@code width} columns; 0 if the width is unknown. */
    static int fit(int width, int longest) {
        return width <= 0 ? Wrapping.USUAL_WIDTH : Math.max(NARROWEST, Math.min(width, longest));
    }

    @Override
    public void watch(Supplier<String> text, Duration period) throws InterruptedException {
        Attributes former = terminal.enterRawMode();
        Attributes keys = terminal.getAttributes();
        // Ctrl-C is an ordinary key here.
        keys.setLocalFlag(Attributes.LocalFlag.ISIG, false);
        terminal.setAttributes(keys);
        String shown = "";
        try {
            do {
                shown = text.get();
                draw(shown + "\n" + WATCHING);
            } while (!isKeyPressed(period));
        } finally {
            drawing.lock();
            try {
                draw(shown);
                live = null;
            } finally {
                drawing.unlock();
            }
            terminal.setAttributes(former);
        }
    }

    private void draw(String text) {
        drawing.lock();
        try {
            LiveText drawn = live == null ? new LiveText(terminal) : live;
            live = drawn;
            drawn.draw(text);
        } finally {
            drawing.unlock();
        }
    }

    private boolean isKeyPressed(Duration period) throws InterruptedException {
        try {
            if (terminal.reader().read(period.toMillis()) == NonBlockingReader.READ_EXPIRED) {
                return false;
            }
            // An arrow key sends several characters.
            while (terminal.reader().read(KEYS_APART_MILLIS) >= 0) {}
            return true;
        } catch (InterruptedIOException interrupt) {
            throw new InterruptedException();
        } catch (IOException gone) {
            return true;
        }
    }

    @Override
    public PrintStream out() {
        return results;
    }

    @Override
    public PrintStream err() {
        return System.err == lines ? results : System.err;
    }

    @Override
    public boolean isTerminal() {
        return true;
    }

    @Override
    public void close() {
        System.setOut(formerOut);
        System.setErr(formerErr);
        lines.close();
        results.close();
        try {
            terminal.close();
        } catch (IOException failure) {
            formerErr.println("error: the terminal could not be restored: " + failure.getMessage());
        }
    }
}
