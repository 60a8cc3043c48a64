package org.evoloop.xmi.uml14;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.xmi.dialect.XmiStream;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * What one file says about state machines: the machines, and by id everything that a machine may refer to. Diagrams and
 * the rest of the model are not kept.
 *
 * <p>Threading: immutable once read.
 */
final class Uml14Document {
    /** Kept with all their contents. */
    private static final Set<String> WHOLE = Set.of(
            "StateMachine",
            "ActivityModel",
            "Event",
            "SignalEvent",
            "CallEvent",
            "TimeEvent",
            "ChangeEvent",
            "Guard",
            "Action",
            "CallAction",
            "SendAction",
            "CreateAction",
            "DestroyAction",
            "ReturnAction",
            "TerminateAction",
            "UninterpretedAction",
            "ActionSequence",
            "Procedure",
            "Transition");

    /** Kept for their names, which events, actions and states use. */
    private static final Set<String> NAMED = Set.of("Signal", "Exception", "Operation", "Reception", "Stereotype");

    /** Written by tools into the middle of a machine, but not part of it. */
    private static final Set<String> PRESENTATION = Set.of("taggedValue", "extension", "presentation", "Diagram");

    private final String file;
    private final Map<String, XmlNode> byId = new HashMap<>();
    private final Set<String> ambiguous = new HashSet<>();
    private final List<Uml14Element> machines = new ArrayList<>();

    private Uml14Document(String file) {
        this.file = file;
    }

    static Uml14Document read(XmiStream stream) {
        Uml14Document document = new Uml14Document(stream.file());
        boolean more = stream.isStartElement() || stream.nextElementWithin(0);
        while (more) {
            String type = Uml14Element.lastPart(stream.getLocalName());
            boolean definition = stream.attribute("xmi.idref").isEmpty()
                    && stream.attribute("href").isEmpty();
            if (type.equals("ActivityGraph") || PRESENTATION.contains(type)) {
                stream.skipElement();
            } else if (definition && WHOLE.contains(type)) {
                document.index(XmlNode.read(stream, Uml14Document::isPresentation));
            } else if (definition && NAMED.contains(type)) {
                // Only its name is needed, so the rest of an operation is skipped.
                document.index(
                        XmlNode.read(stream, inner -> !inner.getLocalName().endsWith(".name")));
            }
            more = stream.nextElementWithin(0);
        }
        document.forgetShells();
        return document;
    }

    /** Enterprise Architect writes an empty machine beside the activity model that has the machine's states. */
    private void forgetShells() {
        if (machines.stream().anyMatch(Uml14Vertices::isActivityModelOfStates)) {
            machines.removeIf(machine -> machine.type().equals("StateMachine")
                    && Uml14Vertices.tops(machine).isEmpty());
        }
    }

    private static boolean isPresentation(XmiStream stream) {
        return PRESENTATION.contains(Uml14Element.lastPart(stream.getLocalName()));
    }

    private void index(XmlNode node) {
        if (Uml14Element.isReference(node)) {
            return;
        }
        String id = node.attribute("xmi.id");
        if (!id.isEmpty() && byId.putIfAbsent(id, node) != null) {
            ambiguous.add(id);
        }
        Uml14Element element = new Uml14Element(node, this);
        if (element.type().equals("StateMachine") || Uml14Vertices.isActivityModelOfStates(element)) {
            machines.add(element);
        }
        node.children().forEach(this::index);
    }

    /** The file's name in messages. */
    String file() {
        return file;
    }

    List<Uml14Element> machines() {
        return machines;
    }

    Optional<Uml14Element> find(String id) {
        return Optional.ofNullable(byId.get(id)).map(node -> new Uml14Element(node, this));
    }

    /** Whether several elements have this id. */
    boolean isAmbiguous(String id) {
        return ambiguous.contains(id);
    }
}
