package org.evoloop.xmi.uml2;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * What one file says about state machines: the machines, and by id everything that a machine may refer to. Diagrams,
 * profiles, the contents of activities and the rest of the model are not kept.
 *
 * <p>Threading: immutable once read.
 */
final class Uml2Document {
    /** Kept with all their contents. */
    private static final Set<String> WHOLE = Set.of(
            "StateMachine",
            "ProtocolStateMachine",
            "Constraint",
            "Trigger",
            "SignalTrigger",
            "CallTrigger",
            "TimeTrigger",
            "ChangeTrigger",
            "AnyTrigger",
            "OpaqueBehavior",
            "FunctionBehavior");

    /** Kept only by name, which events and effects use. */
    private static final Set<String> ALONE =
            Set.of("Signal", "Operation", "Reception", "Activity", "Interaction", "Port", "Property");

    private static final Set<String> PACKAGES = Set.of("Model", "Package", "Profile");

    /**
     * The contents of activities and interactions. They are not needed, since a behavior is referred to by its name.
     */
    private static final Set<String> INSIDE_BEHAVIORS = Set.of(
            "node", "edge", "group", "structuredNode", "partition", "fragment", "lifeline", "message", "formalGate");

    private final String file;
    private final boolean imported;
    private final String exporter;
    private final Map<String, XmlNode> byId = new HashMap<>();
    private final Set<String> ambiguous = new HashSet<>();
    private final List<Uml2Element> machines = new ArrayList<>();
    private final LooseVertices loose = new LooseVertices();
    /** The last element of which only the name is kept, and its depth. */
    private @Nullable XmlNode alone;

    private int aloneDepth;

    private Uml2Document(XmiHead head, XmiStream stream, boolean imported) {
        this.file = stream.file();
        this.imported = imported;
        this.exporter = head.exporter();
    }

    /**
     * @param stream positioned as {@link XmiHead#read} leaves it
     * @param imported whether another file refers to it
     */
    static Uml2Document read(XmiHead head, XmiStream stream, boolean imported) {
        Uml2Document document = new Uml2Document(head, stream, imported);
        document.loose.open(0, head.node());
        boolean more = stream.isStartElement() || stream.nextElementWithin(0);
        while (more) {
            if (isExtension(stream)) {
                stream.skipElement();
            } else if (stream.getLocalName().equals("name") && stream.depth() == document.aloneDepth + 1) {
                document.nameAlone(XmlNode.read(stream, inner -> false).text());
            } else if (stream.attribute("idref").isEmpty()
                    && stream.attribute("href").isEmpty()) {
                document.element(stream);
            }
            more = stream.nextElementWithin(0);
        }
        document.takeLoose();
        return document;
    }

    private void element(XmiStream stream) {
        String type = Uml2Element.type(
                XmlNode.attribute(stream, "xmi:type"), String.valueOf(stream.getNamespaceURI()), stream.getLocalName());
        int depth = stream.depth();
        if (PACKAGES.contains(type)) {
            alone = XmlNode.alone(stream);
            aloneDepth = depth;
            loose.open(depth, alone);
        } else if (WHOLE.contains(type) || type.endsWith("Event")) {
            XmlNode node = XmlNode.read(stream, Uml2Document::isUnwanted);
            index(node);
            if (type.endsWith("StateMachine")) {
                loose.machine(depth, node);
            }
        } else if (LooseVertices.isPart(type)) {
            loose.add(depth, XmlNode.read(stream, Uml2Document::isUnwanted));
        } else if (ALONE.contains(type)) {
            alone = XmlNode.alone(stream);
            aloneDepth = depth;
            remember(alone);
        }
    }

    /** XMI may write a name as an element. */
    private void nameAlone(String name) {
        XmlNode unnamed = requireNonNull(alone);
        List<String> attributes = new ArrayList<>(List.of("name", name));
        unnamed.attributeNames().forEach(each -> attributes.addAll(List.of(each, unnamed.attribute(each))));
        XmlNode named = XmlNode.made(unnamed, unnamed.name(), attributes, List.of());
        byId.replace(named.attribute("xmi:id"), unnamed, named);
        loose.replace(unnamed, named);
    }

    private void takeLoose() {
        for (LooseVertices.Found found : loose.machines()) {
            machines.removeIf(machine -> found.shells().contains(machine.node()));
            byId.remove(found.machine().attribute("xmi:id"));
            index(found.machine());
        }
    }

    private static boolean isExtension(XmiStream stream) {
        return stream.getLocalName().toLowerCase(Locale.ROOT).endsWith("extension")
                && XmlNode.isXmi(String.valueOf(stream.getNamespaceURI()));
    }

    private static boolean isUnwanted(XmiStream stream) {
        return isExtension(stream) || INSIDE_BEHAVIORS.contains(stream.getLocalName());
    }

    private void index(XmlNode node) {
        if (Uml2Element.isReference(node)) {
            return;
        }
        remember(node);
        Uml2Element element = new Uml2Element(node, this);
        if (element.type().endsWith("StateMachine")) {
            machines.add(element);
        }
        node.children().forEach(this::index);
    }

    private void remember(XmlNode node) {
        String id = node.attribute("xmi:id");
        if (id.isEmpty()) {
            return;
        }
        XmlNode earlier = byId.putIfAbsent(id, node);
        // StarUML writes the event of a trigger twice, with the same id.
        if (earlier != null
                && !(earlier.attribute("xmi:type").equals(node.attribute("xmi:type"))
                        && Uml2Element.attribute(earlier, "name").equals(Uml2Element.attribute(node, "name")))) {
            ambiguous.add(id);
        }
    }

    /** The file's name in messages. */
    String file() {
        return file;
    }

    /** Whether another file refers to it, so that messages name it. */
    boolean isImported() {
        return imported;
    }

    /** Whether the file was written by a tool whose name begins like this. */
    boolean isBy(String tool) {
        return exporter.startsWith(tool);
    }

    List<Uml2Element> machines() {
        return machines;
    }

    Optional<Uml2Element> find(String id) {
        return Optional.ofNullable(byId.get(id)).map(node -> new Uml2Element(node, this));
    }

    /** Whether several different elements have this id. */
    boolean isAmbiguous(String id) {
        return ambiguous.contains(id);
    }
}
