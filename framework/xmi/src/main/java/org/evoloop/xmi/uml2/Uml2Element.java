package org.evoloop.xmi.uml2;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.statechart.Place;
import org.evoloop.xmi.dialect.UmlElement;
import org.evoloop.xmi.dialect.XmlNode;

/** A UML element, with the document in which its references are resolved. */
record Uml2Element(XmlNode node, Uml2Document document) implements UmlElement {
    /** The types that a tool may omit, since only one type fits the role. */
    private static final Map<String, String> TYPE_BY_ROLE = Map.of(
            "region", "Region",
            "transition", "Transition",
            "trigger", "Trigger",
            "deferrableTrigger", "Trigger",
            "guard", "Constraint",
            "ownedRule", "Constraint",
            "when", "TimeExpression",
            "connectionPoint", "Pseudostate",
            "connection", "ConnectionPointReference");

    @Override
    public String id() {
        return node.attribute("xmi:id");
    }

    /** The UML type without prefix, such as {@code State}; empty if the file gives none. */
    @Override
    public String type() {
        return type(node.attribute("xmi:type"), node.namespace(), node.name());
    }

    static String type(String attribute, String namespace, String name) {
        if (!attribute.isEmpty()) {
            return attribute.substring(attribute.lastIndexOf(':') + 1);
        }
        return Uml2Dialect.isUml(namespace) ? name : TYPE_BY_ROLE.getOrDefault(name, "");
    }

    /** Its name with single spaces, since some tools break long names; empty if it has none. */
    @Override
    public String name() {
        return attribute("name").strip().replaceAll("\\s+", " ");
    }

    /** A property with a plain value, which XMI writes as an attribute or as an element; empty if there is none. */
    String attribute(String name) {
        return attribute(node, name);
    }

    static String attribute(XmlNode node, String name) {
        String value = node.attribute(name);
        return value.isEmpty()
                ? node.children(name).stream()
                        .filter(Uml2Element::isProperty)
                        .map(XmlNode::text)
                        .collect(Collectors.joining(" "))
                : value;
    }

    /** Whether this is the plain value of a property, and not an element of the model. */
    static boolean isProperty(XmlNode node) {
        return node.attributeCount() == 0
                && node.children().isEmpty()
                && !node.text().isEmpty();
    }

    @Override
    public Place place() {
        return place(node);
    }

    /** The place of something in this element. */
    Place place(XmlNode inner) {
        return new Place(document.isImported() ? document.file() : "", id(), inner.line());
    }

    /** The elements inside this one that have a role; without those it refers to. */
    List<Uml2Element> owned(String role) {
        return node.children(role).stream()
                .filter(child -> !isReference(child) && !isProperty(child))
                .map(child -> new Uml2Element(child, document))
                .toList();
    }

    static boolean isReference(XmlNode node) {
        return !node.attribute("xmi:idref").isEmpty() || !node.attribute("href").isEmpty();
    }

    @Override
    public String file() {
        return document.file();
    }
}
