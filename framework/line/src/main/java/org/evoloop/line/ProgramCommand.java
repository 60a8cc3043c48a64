package org.evoloop.line;

import java.io.File;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.evoloop.converter.Effect;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Values;
import org.evoloop.payload.Template;
import org.evoloop.time.Clock;

/**
 * A program that is run once, with a time limit: {@code aplay beep.wav}. It has obeyed if its exit status is 0. No shell
 * reads the command, so an event's values in its arguments cannot become commands. What it writes to its standard error
 * is logged.
 *
 * <p>Threading: immutable; it may run several times at once.
 *
 * @since 0.1
 */
public final class ProgramCommand implements Effect.OfEvent {
    private static final File NOTHING = new File("/dev/null");

    private final String program;
    private final List<Template> arguments;
    private final Duration limit;
    private final Clock clock;

    /**
     * A command.
     *
     * @param command the program and its arguments, which may contain an event's values, see {@link Template}
     * @param limit how long it may run until it is killed
     * @throws IllegalArgumentException if it names no program
     */
    public ProgramCommand(List<String> command, Duration limit, Clock clock) {
        List<String> all = Programs.requireCommand(command);
        this.program = all.get(0);
        this.arguments = all.subList(1, all.size()).stream().map(Template::of).toList();
        this.limit = Clock.requireDelay(limit);
        this.clock = clock;
    }

    /**
     * Runs it; returns when it has obeyed.
     *
     * @throws UnknownEffectException if it was killed, since it took longer than it may
     * @throws IOException if it cannot be started, or ends with another exit status than 0
     * @throws IllegalArgumentException if the event does not carry a value that it needs
     */
    @Override
    public void run(Values values) throws IOException, InterruptedException {
        List<String> filled = new ArrayList<>(List.of(program));
        arguments.forEach(argument -> filled.add(argument.with(values)));
        String name = Programs.name(List.of(program));
        Process process = Programs.start(
                new ProcessBuilder(Programs.requireCommand(filled))
                        .redirectInput(NOTHING)
                        .redirectOutput(ProcessBuilder.Redirect.DISCARD),
                name);
        AtomicBoolean killed = new AtomicBoolean();
        Clock.Timer timer = clock.schedule(limit, () -> {
            killed.set(true);
            Programs.kill(process);
        });
        try {
            int status = process.waitFor();
            if (killed.get()) {
                throw new UnknownEffectException(
                        name + " took longer than " + limit.toMillis() + " ms, so it was killed");
            } else if (status != 0) {
                throw new IOException(name + " has ended with status " + status);
            }
        } finally {
            timer.cancel();
            Programs.kill(process);
        }
    }

    /** For messages: the program, without arguments. */
    @Override
    public String toString() {
        return Programs.name(List.of(program));
    }
}
