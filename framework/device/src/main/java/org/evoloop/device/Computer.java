package org.evoloop.device;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.line.ProgramCommand;
import org.evoloop.line.RunExecute;
import org.jspecify.annotations.Nullable;

/** What is run on this computer: {@code run: [aplay, beep.wav]}, for a step or an action, without any connection. */
final class Computer extends Connection {
    private static final Duration USUAL_LIMIT = Duration.ofSeconds(10);

    private final Map<String, Run> sent = new LinkedHashMap<>();
    private volatile @Nullable SystemEventConverter joined;

    private record Run(List<String> command, Duration within) {
        ProgramCommand on(SystemEventConverter converter) {
            return new ProgramCommand(command, within, converter.clock());
        }
    }

    Computer() {
        super("run", "run");
    }

    @Override
    public void send(Node.Text event, Section how) {
        sent.put(event.value(), run(how));
    }

    private static Run run(Section section) {
        List<String> command =
                section.texts("run").stream().map(Node.Text::value).toList();
        if (command.isEmpty() || command.get(0).isBlank()) {
            section.problem(section.name() + ".run names no program; write it as [aplay, beep.wav]");
        }
        return new Run(command, section.duration("within").orElse(USUAL_LIMIT));
    }

    @Override
    public Outward outward(Section action) {
        Run run = run(action);
        return values -> run.on(requireNonNull(joined)).run(values);
    }

    @Override
    protected Parts make(SystemEventConverter converter) {
        joined = converter;
        Map<String, ProgramCommand> commands = new LinkedHashMap<>();
        sent.forEach((event, run) -> commands.put(event, run.on(converter)));
        List<EventExecute> executes = commands.isEmpty() ? List.of() : List.of(new RunExecute("RunExecute", commands));
        return new Parts(List.of(), executes, null, () -> {}, () -> {});
    }
}
