package org.evoloop.xmi.uml2;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.statechart.Place;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * The properties allowed in each element of a state machine: those that are read, and those that do not affect
 * behavior. Everything else is reported as a problem, so that nothing is lost silently.
 */
final class Uml2Vocabulary {
    /** Allowed in every element. Attributes with a prefix are a tool's extension. */
    private static final Set<String> ANYWHERE = Set.of(
            "name",
            "visibility",
            "isLeaf",
            "isAbstract",
            "qualifiedName",
            "namespace",
            "owner",
            "clientDependency",
            "nameExpression",
            "ownedComment",
            "elementImport",
            "packageImport",
            "ownedRule",
            "eAnnotations",
            "Extension");

    private static final Set<String> VERTEX = Set.of("incoming", "outgoing", "container", "stateMachine", "state");

    /** A machine is also a class; its class features do not affect its behavior. */
    private static final Set<String> CLASS = Set.of(
            "ownedAttribute",
            "ownedOperation",
            "ownedReception",
            "ownedBehavior",
            "nestedClassifier",
            "ownedConnector",
            "ownedPort",
            "ownedParameter",
            "ownedParameterSet",
            "ownedTrigger",
            "ownedUseCase",
            "ownedMember",
            "ownedDiagram",
            "ownedElement",
            "interfaceRealization",
            "classifierBehavior",
            "isReentrant",
            "isActive",
            "isFinalSpecialization",
            "specification",
            "context",
            "submachineState",
            "conformance",
            "useCase");

    private static final Map<String, Set<String>> BY_TYPE = Map.ofEntries(
            Map.entry("StateMachine", union(CLASS, Set.of("region", "connectionPoint"))),
            Map.entry("ProtocolStateMachine", union(CLASS, Set.of("region", "connectionPoint"))),
            Map.entry("Region", Set.of("subvertex", "transition", "stateMachine", "state")),
            Map.entry(
                    "State",
                    union(
                            VERTEX,
                            Set.of(
                                    "region",
                                    "entry",
                                    "exit",
                                    "doActivity",
                                    "deferrableTrigger",
                                    "connection",
                                    "connectionPoint",
                                    "submachine",
                                    "stateInvariant",
                                    "isComposite",
                                    "isOrthogonal",
                                    "isSimple",
                                    "isSubmachineState"))),
            Map.entry(
                    "FinalState",
                    union(VERTEX, Set.of("isComposite", "isOrthogonal", "isSimple", "isSubmachineState"))),
            Map.entry("Pseudostate", union(VERTEX, Set.of("kind"))),
            Map.entry("ConnectionPointReference", union(VERTEX, Set.of("entry", "exit"))),
            Map.entry("Transition", transition()),
            Map.entry("ProtocolTransition", union(transition(), Set.of("preCondition", "referred"))),
            Map.entry("Trigger", Set.of("event", "port")),
            Map.entry("Constraint", Set.of("specification", "constrainedElement", "context")));

    private Uml2Vocabulary() {}

    private static Set<String> transition() {
        return Set.of("source", "target", "kind", "trigger", "guard", "effect", "container", "ownedMember");
    }

    private static Set<String> union(Set<String> one, Set<String> other) {
        Set<String> both = new HashSet<>(one);
        both.addAll(other);
        return Set.copyOf(both);
    }

    /** Reports everything in the element that is not read. */
    static void check(Uml2Element element, Problems problems) {
        String type = element.type().equals("ProtocolState") ? "State" : element.type();
        Set<String> known = BY_TYPE.getOrDefault(type, Set.of());
        if (!element.node().text().isEmpty()) {
            refuse(
                    element,
                    element.place(),
                    "text " + Problems.quote(element.node().text()),
                    problems);
        }
        for (String name : element.node().attributeNames()) {
            if (isOwn(name) && !isKnown(name, known) && !saysNothing(element.attribute(name))) {
                refuse(element, element.place(), "attribute " + name, problems);
            }
        }
        for (XmlNode child : element.node().children()) {
            boolean silent = Uml2Element.isProperty(child) && saysNothing(child.text());
            if (!isKnown(child.name(), known) && !silent) {
                refuse(element, element.place(child), what(child), problems);
            }
        }
    }

    /** Tools may write default values. */
    private static boolean saysNothing(String value) {
        return value.isEmpty() || value.equals("false");
    }

    /** Whether it is no other tool's extension. */
    private static boolean isOwn(String attribute) {
        return attribute.indexOf(':') < 0 || attribute.startsWith(XmlNode.EVOLOOP);
    }

    private static boolean isKnown(String name, Set<String> known) {
        return known.contains(name) || ANYWHERE.contains(name);
    }

    private static String what(XmlNode child) {
        return Stream.of("element", child.name(), id(child))
                .filter(word -> !word.isEmpty())
                .reduce((left, right) -> left + " " + right)
                .orElse("");
    }

    private static String id(XmlNode child) {
        String id = child.attribute("xmi:id");
        return id.isEmpty() ? "" : "(id " + Problems.quote(id) + ")";
    }

    private static void refuse(Uml2Element element, Place place, String what, Problems problems) {
        problems.add(place, what + " of " + element.type() + " " + element.label() + " is not supported; remove it");
    }
}
