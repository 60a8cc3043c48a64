package org.evoloop.xmi;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.ToIntFunction;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.MachineEditor;
import org.evoloop.xmi.scxml.ScxmlEditor;
import org.evoloop.xmi.text.TextEditor;

/**
 * Edits a machine as its author would edit its text: an edit changes the lines that it concerns and no others, so comments,
 * blank lines and the order of everything stay. States are called by their names, and transitions are found by their lines.
 *
 * <p>What was edited is read again, and the edit is refused if the machine is then not what the edit describes, or if
 * another machine of the file has changed.
 *
 * <p>Errors: a {@link ModelException} says why an edit is refused.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class ModelEditor {
    private static final String BYTE_ORDER_MARK = "\uFEFF";

    private final String file;
    private final String mark;
    private final String text;
    private final String machine;

    /**
     * An edited text.
     *
     * @param line that shows the edit, from 1
     */
    public record Edited(String text, int line) {}

    /**
     * An editor of one machine of a text.
     *
     * @param file its name, which tells the language
     * @param machine its name; empty for the only one
     */
    public ModelEditor(String file, String text, String machine) {
        this.file = file;
        this.mark = text.startsWith(BYTE_ORDER_MARK) ? BYTE_ORDER_MARK : "";
        this.text = text.substring(mark.length());
        this.machine = machine;
    }

    /** Whether the machine has a state of that name; not if it cannot be read. */
    public boolean hasState(String name) {
        ModelFile whole = read(text);
        XmiMachine of = machine.isEmpty() ? whole.findOnly() : whole.find(machine);
        try {
            return facts(of).hasState(name);
        } catch (ModelException mistaken) {
            return false;
        }
    }

    /** Adds a state, in the state {@code parent} or, if that is empty, at the top. The first in a region is its start. */
    public Edited addState(String name, String parent) {
        return edit(editor -> editor.addState(name, parent), (before, after) -> before.withState(name, parent, after));
    }

    /** Adds a transition; {@code event} and {@code guard} may be empty. */
    public Edited addTransition(String source, String target, String event, String guard) {
        return edit(
                editor -> editor.addTransition(source, target, event, guard),
                (before, after) -> before.withOneMore(source, target, after));
    }

    /** Renames a state. If it is one of the device's, states that want the device there are not changed. */
    public Edited renameState(String from, String to) {
        return edit(editor -> editor.renameState(from, to), (before, after) -> before.renamed(from, to));
    }

    /** Renames the device's state {@code from} where new states want the device there. */
    public Edited renameDeviceState(String from, String to) {
        return edit(
                editor -> {
                    editor.renameDeviceState(from, to);
                    return 1;
                },
                (before, after) -> before.withDeviceRenamed(from, to));
    }

    /** Gives the transition in a line other events, separated by commas. */
    public Edited setTrigger(int line, String event) {
        return edit(editor -> editor.setTrigger(line, event), (before, after) -> before.relabelled(line, after));
    }

    /** Gives the transition in a line another guard; none if it is empty. */
    public Edited setGuard(int line, String guard) {
        return edit(editor -> editor.setGuard(line, guard), (before, after) -> before.relabelled(line, after));
    }

    /** Says in which state the device must be while the machine is in {@code state}; anywhere if it is empty. */
    public Edited setDeviceState(String state, String device) {
        return edit(
                editor -> editor.setDeviceState(state, device), (before, after) -> before.withDevice(state, device));
    }

    /** Makes a state the start of its region. */
    public Edited setInitial(String state) {
        return edit(editor -> editor.setInitial(state), (before, after) -> before.startingIn(state, after));
    }

    /** Gives the transition in a line other ends; an empty name keeps one. */
    public Edited retarget(int line, String source, String target) {
        return edit(
                editor -> editor.retarget(line, source, target),
                (before, after) -> before.retargeted(line, source, target));
    }

    /** Removes the transition in a line. */
    public Edited deleteTransition(int line) {
        return edit(editor -> editor.deleteTransition(line), (before, after) -> before.without(line));
    }

    /** Removes a state with its contents, and all transitions from and to them. */
    public Edited deleteState(String state) {
        return edit(editor -> editor.deleteState(state), (before, after) -> before.withoutState(state));
    }

    /** What a machine must be after an edit. */
    private interface Expected {
        ChartFacts of(ChartFacts before, ChartFacts after);
    }

    private Edited edit(ToIntFunction<MachineEditor> change, Expected expected) {
        ModelFile file = read(text);
        XmiMachine edited = machine.isEmpty() ? file.findOnly() : file.find(machine);
        MachineEditor editor = editor(edited.line());
        ChartFacts before = editor.isEmpty() ? ChartFacts.NONE : facts(edited);
        int line = change.applyAsInt(editor);
        String changed = editor.text();
        ModelFile result = read(changed);
        int index = file.machines().indexOf(edited);
        if (result.machines().size() != file.machines().size()) {
            throw unsure("the file would have another number of machines");
        }
        ChartFacts after = facts(result.machines().get(index));
        if (!expected.of(before, after).equals(after)) {
            throw unsure("the machine would be another one than this edit describes");
        }
        for (int i = 0; i < file.machines().size(); i++) {
            if (i != index
                    && !all(file.machines().get(i)).equals(all(result.machines().get(i)))) {
                throw unsure("another machine of the file would change");
            }
        }
        return new Edited(mark + changed, line);
    }

    private ModelFile read(String content) {
        return ModelFile.read(file, new ByteArrayInputStream(content.getBytes(StandardCharsets.UTF_8)));
    }

    private static ChartFacts facts(XmiMachine of) {
        return ChartFacts.of(of.statechart());
    }

    /** Of a machine that may have mistakes, which then must stay the same. */
    private static List<Object> all(XmiMachine of) {
        List<Object> all = new ArrayList<>(List.of(of.name()));
        try {
            Statechart chart = of.statechart();
            all.add(ChartFacts.of(chart));
        } catch (ModelException mistaken) {
            all.add(String.valueOf(mistaken.getMessage()).replaceAll("line \\d+", "line"));
        }
        return all;
    }

    private static ModelException unsure(String why) {
        return new ModelException("this edit is not done, since " + why + "; edit the text by hand");
    }

    private MachineEditor editor(int line) {
        String name = file.toLowerCase(Locale.ROOT);
        if (name.endsWith(".scxml") || text.stripLeading().startsWith("<")) {
            return new ScxmlEditor(file, text);
        }
        return TextEditor.of(file, text, line);
    }
}
