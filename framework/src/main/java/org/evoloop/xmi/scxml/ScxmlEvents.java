package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * Which events a transition's descriptors match. {@code a} matches {@code a}, {@code a.b} and so on, {@code *} everything
 * (SCXML 1.0, section 3.12.1); of the endlessly many, these are the events that the document names anywhere, and
 * {@code *} for one that it does not name.
 */
final class ScxmlEvents {
    private static final String DONE = "done.state.";
    private static final String ANY = "*";

    private final ScxmlTree tree;
    private final Problems problems;
    private final Set<String> named = new TreeSet<>();

    ScxmlEvents(ScxmlTree tree, Problems problems) {
        this.tree = tree;
        this.problems = problems;
        tree.document().children().forEach(this::collect);
    }

    private void collect(XmlNode node) {
        switch (node.name()) {
            case "transition", "send", "raise" ->
                descriptors(node).stream()
                        .filter(name -> doneState(name) == null)
                        .forEach(name -> named.add(name.isEmpty() ? ANY : name));
            default -> {}
        }
        node.children().forEach(this::collect);
    }

    /** Each without what says no more than that it is a prefix. */
    private static List<String> descriptors(XmlNode transition) {
        List<String> descriptors = new ArrayList<>();
        String event = transition.attribute("event").strip();
        for (String descriptor : event.isEmpty() ? new String[0] : event.split("\\s+", -1)) {
            String name = descriptor;
            while (name.endsWith(".*") || name.endsWith(".")) {
                name = name.substring(0, name.lastIndexOf('.'));
            }
            descriptors.add(name.equals(ANY) ? "" : name);
        }
        return descriptors;
    }

    private @Nullable XmlNode doneState(String descriptor) {
        XmlNode state = descriptor.startsWith(DONE) ? tree.find(descriptor.substring(DONE.length())) : null;
        return state != null && tree.canBeDone(state) ? state : null;
    }

    /** States whose being done triggers the transition. */
    List<XmlNode> doneStates(XmlNode transition) {
        List<XmlNode> states = new ArrayList<>();
        for (String descriptor : descriptors(transition)) {
            XmlNode state = doneState(descriptor);
            if (state != null) {
                states.add(state);
            }
        }
        return states;
    }

    /** Names of all other events that trigger it. */
    List<String> triggers(XmlNode transition, XmlNode state, String label) {
        Set<String> triggers = new LinkedHashSet<>();
        for (String descriptor : descriptors(transition)) {
            if (doneState(descriptor) != null) {
                continue;
            }
            if (DONE.startsWith(descriptor.isEmpty() ? "" : descriptor + ".") && tree.mayHearOfDone(state)) {
                problems.add(
                        transition.line(),
                        label + " matches the events of all states that can be done, which is not supported; "
                                + "name the events");
            }
            named.stream()
                    .filter(event ->
                            descriptor.isEmpty() || event.equals(descriptor) || event.startsWith(descriptor + "."))
                    .forEach(triggers::add);
        }
        return List.copyOf(triggers);
    }
}
