package org.evoloop.xmi;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;

/**
 * The state machines of one XMI file. A machine that cannot be used disturbs nobody until it is picked.
 *
 * <p>Threading: immutable once read.
 */
public final class XmiFile {
    private static final List<XmiDialect> DIALECTS = List.of(new AstahDialect());
    private static final int NAMES_LISTED = 50;

    private final Path file;
    private final List<XmiMachine> machines;

    private XmiFile(Path file, List<XmiMachine> machines) {
        this.file = file;
        this.machines = machines;
    }

    /**
     * Reads the file once, in bounded memory.
     *
     * @throws ModelException if it cannot be read, is not well-formed XML, is of no supported dialect, or is too large;
     *     its machines are checked only when they are picked
     */
    public static XmiFile read(Path file) {
        try (XmiStream stream = XmiStream.open(file)) {
            XmiHead head = XmiHead.read(stream);
            for (XmiDialect dialect : DIALECTS) {
                if (dialect.recognises(head)) {
                    return new XmiFile(file, List.copyOf(dialect.read(stream)));
                }
            }
            throw stream.refuse(
                    "found " + head + ", which is not supported",
                    "use " + DIALECTS.stream().map(XmiDialect::toString).collect(Collectors.joining(" or ")));
        }
    }

    /**
     * The machine that {@code FILE#NAME} or {@code FILE} refers to, see {@link ModelReference#parse}.
     *
     * @throws ModelException if there is no such file or machine, or the machine cannot be used as it is
     */
    public static StateMachine machine(String reference) {
        return ModelReference.parse(reference).load();
    }

    /** Every machine of the file, in the file's order; empty if it holds none. */
    public List<XmiMachine> machines() {
        return machines;
    }

    /**
     * The machine whose diagram name, own name or id is {@code name}.
     *
     * @throws ModelException if none or several have it, or the machine cannot be used as it is
     */
    public StateMachine pick(String name) {
        String wanted = name.strip();
        List<XmiMachine> found =
                machines.stream().filter(machine -> machine.answersTo(wanted)).toList();
        if (found.size() == 1) {
            return found.get(0).toStateMachine();
        }
        requireSome();
        if (found.isEmpty()) {
            throw new ModelException(
                    file + ": no state machine is named " + Problems.quote(wanted) + "; there is " + list(machines));
        }
        throw new ModelException(file + ": " + Problems.quote(wanted) + " names " + found.size()
                + " state machines; choose one by its id, or give them different names: " + list(found));
    }

    /**
     * The file's only machine.
     *
     * @throws ModelException if the file holds none or several, or the machine cannot be used as it is
     */
    public StateMachine only() {
        requireSome();
        if (machines.size() > 1) {
            throw new ModelException(file + ": holds " + machines.size() + " state machines; choose one by " + file
                    + "#NAME, there is " + list(machines));
        }
        return machines.get(0).toStateMachine();
    }

    private void requireSome() {
        if (machines.isEmpty()) {
            throw new ModelException(
                    file + ": holds no state machine; in Astah draw a State Machine Diagram and save with "
                            + AstahDialect.MENU);
        }
    }

    private static String list(List<XmiMachine> some) {
        String names = some.stream().limit(NAMES_LISTED).map(XmiFile::describe).collect(Collectors.joining(", "));
        return some.size() > NAMES_LISTED ? names + " and " + (some.size() - NAMES_LISTED) + " more" : names;
    }

    private static String describe(XmiMachine machine) {
        return Problems.quote(machine.name()) + " (machine " + Problems.quote(machine.machineName()) + ", id "
                + machine.id() + ", line " + machine.line() + ")";
    }
}
