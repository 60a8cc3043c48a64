package org.evoloop.console;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import org.jline.reader.Candidate;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.UserInterruptException;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import org.jline.terminal.spi.SystemStream;
import org.jline.terminal.spi.TerminalExt;
import org.jspecify.annotations.Nullable;

/**
 * A terminal, with line editing, completion, and a history that lasts as long as the console.
 *
 * <p>{@code System.out}, and {@code System.err} if it shows on the terminal as well, are replaced meanwhile: what other
 * threads print appears above the line that is being edited.
 */
final class TerminalIo implements ConsoleIo {
    private static final String PROMPT = "evoloop> ";

    private final Terminal terminal;
    private final LineReader reader;
    private final PrintStream lines;
    private final PrintStream formerOut = System.out;
    private final PrintStream formerErr = System.err;

    /**
     * @param showsErrors whether the error output of this process is the same terminal
     * @param completion the words that may stand after those given
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
        this.lines = LineStream.printer(reader::printAbove);
        terminal.handle(Terminal.Signal.INT, signal -> interrupted.run());
        System.setOut(lines);
        if (showsErrors) {
            System.setErr(lines);
        }
    }

    /** The terminal that this process was started on; null if it is none, or one that cannot move its cursor. */
    static @Nullable TerminalIo open(Function<List<String>, Collection<String>> completion, Runnable interrupted) {
        try {
            Terminal terminal = TerminalBuilder.builder()
                    .systemOutput(TerminalBuilder.SystemOutput.SysOut)
                    .dumb(true)
                    .build();
            if (terminal.getType().startsWith(Terminal.TYPE_DUMB)) {
                terminal.close();
                return null;
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
        try {
            return reader.readLine(PROMPT);
        } catch (UserInterruptException controlC) {
            throw new InterruptedException();
        } catch (EndOfFileException controlD) {
            return null;
        }
    }

    @Override
    public PrintStream out() {
        return lines;
    }

    @Override
    public PrintStream err() {
        return System.err;
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
        try {
            terminal.close();
        } catch (IOException failure) {
            formerErr.println("error: the terminal could not be restored: " + failure.getMessage());
        }
    }
}
