package org.evoloop.line;

import java.io.IOException;
import java.util.Map;
import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;

/**
 * Sends events to a device by running programs:
 *
 * <pre>{@code
 * new RunExecute("Socket", Map.of("power", new ProgramCommand(List.of("./socket.sh", "toggle"), Duration.ofSeconds(5), clock)))
 * }</pre>
 *
 * <p>A step has been executed when its program ends with status 0; with any other it has failed, and had no effect. If
 * the program takes too long it is killed, and whether the step had its effect is unknown.
 *
 * <p>Threading: as {@link EventExecute}.
 *
 * @since 0.1
 */
public class RunExecute extends EventExecute {
    private final Map<String, ProgramCommand> commands;

    /**
     * A component that sends these events.
     *
     * @param name its name in the console, unique within a converter
     * @param commands the programs to run, by event
     */
    public RunExecute(String name, Map<String, ProgramCommand> commands) {
        super(name);
        this.commands = Map.copyOf(commands);
    }

    @Override
    protected final Set<String> sendableEvents() {
        return commands.keySet();
    }

    @Override
    protected void send(Step step) throws IOException, InterruptedException {
        ProgramCommand command = commands.get(step.event().name());
        if (command == null) {
            throw new IllegalArgumentException(name() + " has no program for " + step.event());
        }
        command.run(values());
    }
}
