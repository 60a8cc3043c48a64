package org.evoloop.xmi;

import java.util.Map;
import java.util.Optional;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;

/** A state machine of an Astah file, as it stands there. */
final class AstahMachine implements XmiMachine {
    private final String file;
    private final AstahUnmarshaller.Result result;
    private final Map<String, String> diagramNames;
    private final Map<String, String> eventNames;

    /**
     * @param diagramNames by machine id, complete when the file has been read to its end
     * @param eventNames by event id, complete when the file has been read to its end
     */
    AstahMachine(
            String file,
            AstahUnmarshaller.Result result,
            Map<String, String> diagramNames,
            Map<String, String> eventNames) {
        this.file = file;
        this.result = result;
        this.diagramNames = diagramNames;
        this.eventNames = eventNames;
    }

    @Override
    public String id() {
        return result.machine().id();
    }

    @Override
    public String machineName() {
        return result.machine().name();
    }

    @Override
    public Optional<String> diagramName() {
        return Optional.ofNullable(diagramNames.get(id())).filter(name -> !name.isEmpty());
    }

    @Override
    public int line() {
        return result.machine().line;
    }

    @Override
    public StateMachine toStateMachine() {
        AstahFlatReader reader = new AstahFlatReader(result, eventNames, StateMachine.named(name()));
        Problems problems = reader.read();
        if (problems.isEmpty()) {
            return reader.machine();
        }
        throw new ModelException(file + ": state machine " + AstahXml.label(name(), id()) + " (line " + line()
                + ") has " + (problems.count() == 1 ? "a problem:" : problems.count() + " problems:") + problems);
    }
}
