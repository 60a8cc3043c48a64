package org.evoloop.xmi.uml14;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * The properties allowed in each element of a state machine: those that are read, and those that do not affect
 * behavior. Everything else is reported as a problem, so that nothing is lost silently.
 */
final class Uml14Vocabulary {
    private static final Set<String> ANYWHERE = Set.of(
            "name",
            "visibility",
            "isSpecification",
            "isRoot",
            "isLeaf",
            "isAbstract",
            "namespace",
            "stereotype",
            "comment",
            "clientDependency",
            "supplierDependency",
            "id",
            "uuid",
            "label");

    /** Properties that hold elements, and no text. */
    private static final Set<String> ELEMENTS = Set.of(
            "top",
            "transitions",
            "subvertex",
            "substate",
            "entry",
            "exit",
            "doActivity",
            "internalTransition",
            "deferrableEvent",
            "trigger",
            "guard",
            "effect",
            "source",
            "target",
            "submachine");

    private static final Set<String> VERTEX = Set.of("container", "incoming", "outgoing", "stateMachine");

    private static final Set<String> STATE = union(
            VERTEX,
            Set.of("entry", "exit", "doActivity", "internalTransition", "deferrableEvent", "isRegion", "isOrthogonal"));

    private static final Set<String> COMPOSITE =
            union(STATE, Set.of("subvertex", "substate", "isConcurrent", "isConcurent"));

    private static final Map<String, Set<String>> BY_TYPE = Map.ofEntries(
            Map.entry(
                    "StateMachine",
                    Set.of(
                            "top",
                            "transitions",
                            "context",
                            "submachineState",
                            "subMachineState",
                            "ownedElement",
                            "behavior")),
            Map.entry("SimpleState", STATE),
            Map.entry("State", COMPOSITE),
            Map.entry("CompositeState", COMPOSITE),
            Map.entry("SubmachineState", union(COMPOSITE, Set.of("submachine"))),
            Map.entry("FinalState", VERTEX),
            Map.entry("Pseudostate", union(VERTEX, Set.of("kind"))),
            Map.entry("PseudoState", union(VERTEX, Set.of("kind"))),
            Map.entry("StubState", union(VERTEX, Set.of("referenceState"))),
            Map.entry("Transition", Set.of("source", "target", "trigger", "guard", "effect", "stateMachine", "state")));

    private Uml14Vocabulary() {}

    private static Set<String> union(Set<String> one, Set<String> other) {
        Set<String> both = new HashSet<>(one);
        both.addAll(other);
        return Set.copyOf(both);
    }

    /** Reports everything in the element that is not read. */
    static void check(Uml14Element element, Problems problems) {
        Set<String> known = BY_TYPE.getOrDefault(element.type(), Set.of());
        if (!element.node().text().isEmpty()) {
            refuse(element, element.line(), text(element.node()), problems);
        }
        for (String attribute : element.node().attributeNames()) {
            // Attributes with another prefix are a tool's extension.
            String name = attribute.startsWith("xmi.") ? Uml14Element.lastPart(attribute) : attribute;
            String value = element.node().attribute(attribute);
            boolean saysNothing = value.isEmpty() || value.equals("false");
            if (isOwn(name) && !isKnown(name, known) && !saysNothing) {
                refuse(element, element.line(), "attribute " + name, problems);
            }
        }
        for (XmlNode child : element.node().children()) {
            if (!Uml14Element.isProperty(child) || !isKnown(Uml14Element.lastPart(child.name()), known)) {
                refuse(element, child.line(), "element " + child.name(), problems);
            } else if (ELEMENTS.contains(Uml14Element.lastPart(child.name()))
                    && !child.text().isEmpty()) {
                refuse(element, child.line(), text(child) + " in " + child.name(), problems);
            }
        }
    }

    private static String text(XmlNode node) {
        return "text " + Problems.quote(node.text());
    }

    /** Whether it is no other tool's extension. */
    private static boolean isOwn(String attribute) {
        return attribute.indexOf(':') < 0 || attribute.startsWith(XmlNode.EVOLOOP);
    }

    private static boolean isKnown(String name, Set<String> known) {
        return known.contains(name) || ANYWHERE.contains(name);
    }

    private static void refuse(Uml14Element element, int line, String what, Problems problems) {
        problems.add(line, what + " of " + element.type() + " " + element.label() + " is not supported; remove it");
    }
}
