package org.evoloop.xmi;

import java.io.InputStream;
import java.nio.file.Path;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.astah.AstahDialect;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.ModelInput;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmiDialect;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;
import org.evoloop.xmi.scxml.ScxmlDialect;
import org.evoloop.xmi.text.TextDialect;
import org.evoloop.xmi.uml14.Uml14Dialect;
import org.evoloop.xmi.uml2.Uml2Dialect;

/**
 * The state machines of one model file: XMI, SCXML, or a text in Mermaid, PlantUML or Markdown. A machine that cannot
 * be used causes an error only when it is picked.
 *
 * <p>Threading: immutable once read.
 *
 * @since 0.1
 */
public final class ModelFile {
    private static final List<XmiDialect> DIALECTS =
            List.of(new AstahDialect(), new Uml14Dialect(), new Uml2Dialect(), new ScxmlDialect());
    private static final int NAMES_LISTED = 50;

    private final String file;
    private final String exporter;
    private final List<XmiMachine> machines;

    /** @param exporter the file's name for the tool that wrote it */
    private ModelFile(String file, String exporter, List<XmiMachine> machines) {
        this.file = file;
        this.exporter = exporter;
        this.machines = machines;
    }

    /**
     * Preloads the bindings for Astah's files, which takes longer than reading a file. A program that has other work to
     * do first can call this on another thread; reads that start in the meantime wait for it.
     */
    public static void prepare() {
        AstahDialect.prepare();
    }

    /**
     * Reads the file once, in bounded memory.
     *
     * @throws ModelException if it cannot be read, is neither well-formed XML nor text with state diagrams, has an unsupported dialect, or is too large;
     *     its machines are checked only when they are picked
     */
    public static ModelFile read(Path file) {
        return read(ModelInput.open(file));
    }

    /**
     * Reads a model that is not a separate file, such as a resource in a jar.
     *
     * @param name its name in messages
     * @param bytes closed in any case
     * @throws ModelException as in {@link #read(Path)}
     */
    public static ModelFile read(String name, InputStream bytes) {
        return read(ModelInput.of(name, bytes));
    }

    private static ModelFile read(ModelInput input) {
        if (TextDialect.recognises(input)) {
            return new ModelFile(input.file(), "", machines(input.file(), TextDialect.read(input)));
        }
        try (XmiStream stream = XmiStream.of(input)) {
            XmiHead head = XmiHead.read(stream);
            stream.refuseForeign(head);
            for (XmiDialect dialect : DIALECTS) {
                if (dialect.recognises(head)) {
                    String file = stream.file();
                    return new ModelFile(file, head.exporter(), machines(file, dialect.read(head, stream)));
                }
            }
            throw stream.refuse(
                    "found " + head + ", which is not supported",
                    "use " + DIALECTS.stream().map(XmiDialect::toString).collect(Collectors.joining(" or ")) + " or "
                            + TextDialect.NAME);
        }
    }

    private static List<XmiMachine> machines(String file, List<DrawnMachine> drawn) {
        return drawn.stream().map(machine -> new XmiMachine(file, machine)).toList();
    }

    /**
     * The machine that {@code FILE#NAME} or {@code FILE} refers to, see {@link ModelReference#parse}.
     *
     * @throws ModelException if there is no such file or machine, or the machine cannot be used as it is
     */
    public static StateMachine machine(String reference) {
        return ModelReference.parse(reference).load();
    }

    /**
     * A copy that uses this unit for time triggers given as a bare number.
     *
     * @param unit milliseconds or seconds
     */
    public ModelFile withTimeUnit(ChronoUnit unit) {
        return new ModelFile(
                file,
                exporter,
                machines.stream().map(machine -> machine.withTimeUnit(unit)).toList());
    }

    /** Every machine of the file, in the file's order; empty if there is none. */
    public List<XmiMachine> machines() {
        return machines;
    }

    /** The reference to pass to {@link #machine(String)} for each machine of the file, in the file's order. */
    public List<String> references() {
        return machines.stream().map(machine -> file + "#" + machine.name()).toList();
    }

    /**
     * The machine whose diagram name, own name or id is {@code name}.
     *
     * @throws ModelException if none or several have it, or the machine cannot be used as it is
     */
    public StateMachine pick(String name) {
        return find(name).toStateMachine();
    }

    /**
     * The machine whose diagram name, own name or id is {@code name}, unchecked.
     *
     * @throws ModelException if none or several have it
     */
    public XmiMachine find(String name) {
        String wanted = name.strip();
        List<XmiMachine> found =
                machines.stream().filter(machine -> machine.answersTo(wanted)).toList();
        if (found.size() == 1) {
            return found.get(0);
        }
        requireSome();
        if (found.isEmpty()) {
            String meant =
                    Names.meant(wanted, machines.stream().map(XmiMachine::name).toList());
            throw new ModelException(file + ": no state machine is named " + Problems.quote(wanted) + meant
                    + (meant.isEmpty() ? "; there is " : " There is ") + list(machines));
        }
        throw new ModelException(file + ": " + Problems.quote(wanted) + " names " + found.size()
                + " state machines; choose one by its id, or give them different names: " + list(found));
    }

    /**
     * The file's only machine.
     *
     * @throws ModelException if the file contains none or several, or the machine cannot be used
     */
    public StateMachine only() {
        return findOnly().toStateMachine();
    }

    /**
     * The file's only machine, unchecked.
     *
     * @throws ModelException if the file holds none or several
     */
    public XmiMachine findOnly() {
        requireSome();
        if (machines.size() > 1) {
            throw new ModelException(file + ": holds " + machines.size() + " state machines; choose one by " + file
                    + "#NAME, there is " + list(machines));
        }
        return machines.get(0);
    }

    private void requireSome() {
        if (machines.isEmpty() && exporter.toLowerCase(Locale.ROOT).startsWith("umbrello")) {
            throw new ModelException(file + ": was written by Umbrello, which saves state diagrams as pictures, without"
                    + " what is connected with what; draw the machine in another tool, or write it in SCXML");
        }
        if (machines.isEmpty() && (file.endsWith(".di") || file.endsWith(".notation"))) {
            throw new ModelException(file + ": is what Papyrus draws, and not the model; name the .uml file beside it");
        }
        if (machines.isEmpty()) {
            throw new ModelException(file + ": holds no state machine; draw one and export the file again");
        }
    }

    private static String list(List<XmiMachine> some) {
        String names =
                some.stream().limit(NAMES_LISTED).map(ModelFile::describe).collect(Collectors.joining(", "));
        return some.size() > NAMES_LISTED ? names + " and " + (some.size() - NAMES_LISTED) + " more" : names;
    }

    private static String describe(XmiMachine machine) {
        return Problems.quote(machine.name()) + " (machine " + Problems.quote(machine.machineName()) + ", id "
                + machine.id() + ", line " + machine.line() + ")";
    }
}
