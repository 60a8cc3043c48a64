package org.evoloop.xmi.uml2;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * States and transitions that are in a package and not in a state machine, as Visual Paradigm writes them. Those of one
 * package become one machine.
 */
final class LooseVertices {
    private static final Set<String> VERTICES = Set.of("State", "FinalState", "Pseudostate");
    private static final Set<String> ROLES = Set.of("ownedMember", "packagedElement", "ownedElement");

    private final Deque<Open> open = new ArrayDeque<>();
    private final List<Open> withVertices = new ArrayList<>();

    /** A package, and the parts of a machine in it. */
    private record Open(int depth, XmlNode element, List<XmlNode> shells, List<XmlNode> parts) {}

    /**
     * A machine made of loose vertices.
     *
     * @param shells empty machines that it replaces
     */
    record Found(XmlNode machine, List<XmlNode> shells) {}

    static boolean isPart(String type) {
        return VERTICES.contains(type) || type.equals("Transition");
    }

    /** Enters a package. */
    void open(int depth, XmlNode element) {
        around(depth);
        open.push(new Open(depth, element, new ArrayList<>(), new ArrayList<>()));
    }

    /** Replaces the package that was entered last. */
    void replace(XmlNode unnamed, XmlNode named) {
        Open last = open.element();
        if (last.element() == unnamed) {
            open.pop();
            open.push(new Open(last.depth(), named, last.shells(), last.parts()));
        }
    }

    /** Leaves the packages that have ended before an element of this depth. */
    private void around(int depth) {
        while (open.size() > 1 && open.element().depth() >= depth) {
            open.pop();
        }
    }

    /** Adds a state machine that has been read. */
    void machine(int depth, XmlNode machine) {
        around(depth);
        boolean shell = machine.children("region").stream()
                .allMatch(region -> region.children("subvertex").isEmpty());
        if (shell) {
            open.element().shells().add(machine);
        }
    }

    /** Adds a vertex or transition that has been read. */
    void add(int depth, XmlNode part) {
        around(depth);
        Open owner = open.element();
        if (owner.parts().isEmpty()) {
            withVertices.add(owner);
        }
        owner.parts().add(part);
    }

    /** The machines of all packages that have vertices. */
    List<Found> machines() {
        List<Found> found = new ArrayList<>();
        for (Open owner : withVertices) {
            XmlNode named = owner.shells().size() == 1 ? owner.shells().get(0) : owner.element();
            List<XmlNode> parts = new ArrayList<>(owner.parts());
            owner.shells()
                    .forEach(shell -> shell.children("region").forEach(region -> parts.addAll(region.children())));
            XmlNode region = region(owner.element(), parts);
            if (!region.children("subvertex").isEmpty()) {
                found.add(new Found(
                        XmlNode.made(
                                named,
                                "packagedElement",
                                List.of(
                                        "xmi:type",
                                        "uml:StateMachine",
                                        "xmi:id",
                                        named.attribute("xmi:id"),
                                        "name",
                                        Uml2Element.attribute(named, "name")),
                                List.of(region)),
                        owner.shells()));
            }
        }
        return found;
    }

    private static XmlNode region(XmlNode from, List<XmlNode> parts) {
        return XmlNode.made(from, "region", List.of("xmi:type", "uml:Region"), tidy(parts));
    }

    /** Each part in the role that UML defines for it. */
    private static List<XmlNode> tidy(List<XmlNode> parts) {
        List<XmlNode> tidy = new ArrayList<>();
        for (XmlNode part : parts) {
            String type = Uml2Element.type(part.attribute("xmi:type"), part.namespace(), part.name());
            if (VERTICES.contains(type)) {
                tidy.add(part.as("subvertex", inState(part)));
            } else if (type.equals("Transition")) {
                tidy.add(part.as("transition", part.children()));
            } else if (type.equals("Region")) {
                tidy.add(part.as("region", tidy(part.children())));
            } else {
                tidy.add(part);
            }
        }
        return tidy;
    }

    /** The contents of a state; vertices directly in it are put into a region. */
    private static List<XmlNode> inState(XmlNode state) {
        List<XmlNode> loose = new ArrayList<>();
        List<XmlNode> others = new ArrayList<>();
        for (XmlNode child : state.children()) {
            String type = Uml2Element.type(child.attribute("xmi:type"), child.namespace(), child.name());
            (ROLES.contains(child.name()) && isPart(type) ? loose : others).add(child);
        }
        List<XmlNode> tidy = tidy(others);
        if (!loose.isEmpty()) {
            tidy.add(region(state, loose));
        }
        return tidy;
    }
}
