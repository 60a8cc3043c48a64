package org.evoloop.xmi.uml14;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.UmlElement;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * An element of UML 1.x. Its properties are attributes, or elements such as {@code UML:Transition.source} that contain
 * other elements, or in XMI 1.0 texts. An element's class is the last part of its name, since XMI 1.0 writes {@code
 * Behavioral_Elements.State_Machines.Transition}.
 */
record Uml14Element(XmlNode node, Uml14Document document) implements UmlElement {

    @Override
    public String id() {
        return node.attribute("xmi.id");
    }

    /** Its UML class, such as {@code SimpleState}. */
    @Override
    public String type() {
        return lastPart(node.name());
    }

    /** {@code source} for {@code Transition.source}. */
    static String lastPart(String name) {
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** Whether the node is a property and not a UML element. */
    static boolean isProperty(XmlNode node) {
        return Character.isLowerCase(lastPart(node.name()).charAt(0));
    }

    static boolean isReference(XmlNode node) {
        return !node.attribute("xmi.idref").isEmpty() || !node.attribute("href").isEmpty();
    }

    /** Its name with single spaces; empty if it has none. */
    @Override
    public String name() {
        return text("name").strip().replaceAll("\\s+", " ");
    }

    /** The text of a property; empty if it has none. */
    String text(String property) {
        String attribute = node.attribute(property);
        if (!attribute.isEmpty()) {
            return attribute;
        }
        return properties(property)
                .map(child -> child.text().isEmpty() ? child.attribute("xmi.value") : child.text())
                .filter(text -> !text.isEmpty())
                .findFirst()
                .orElse("");
    }

    private Stream<XmlNode> properties(String property) {
        return node.children().stream()
                .filter(child -> isProperty(child) && lastPart(child.name()).equals(property));
    }

    /** The elements inside this one that belong to a property; without those it refers to. */
    List<Uml14Element> owned(String property) {
        return properties(property)
                .flatMap(child -> child.children().stream())
                .filter(child -> !isReference(child))
                .map(child -> new Uml14Element(child, document))
                .toList();
    }

    /** The elements of a property, inside this one or by reference; reports unknown references. */
    List<Uml14Element> all(String property, Problems problems) {
        List<Uml14Element> found = new ArrayList<>();
        String ids = node.attribute(property).strip();
        if (!ids.isEmpty()) {
            for (String id : ids.split("\\s+", -1)) {
                find(property, id, problems, found);
            }
        }
        properties(property).flatMap(child -> child.children().stream()).forEach(child -> {
            if (!child.attribute("xmi.idref").isEmpty()) {
                find(property, child.attribute("xmi.idref"), problems, found);
            } else if (!child.attribute("href").isEmpty()) {
                problems.add(
                        child.line(),
                        property + " of " + type() + " " + label() + " refers to another file, "
                                + Problems.quote(child.attribute("href")) + "; put the element into this model");
            } else {
                found.add(new Uml14Element(child, document));
            }
        });
        return found;
    }

    /** The names of its stereotypes; those of other files, such as a tool's profile, are passed over. */
    List<String> stereotypes() {
        Stream<String> ids = Stream.concat(
                Stream.of(node.attribute("stereotype").strip().split("\\s+", -1)),
                properties("stereotype")
                        .flatMap(child -> child.children().stream())
                        .map(child -> child.attribute("xmi.idref").isEmpty()
                                ? child.attribute("xmi.id")
                                : child.attribute("xmi.idref")));
        return ids.flatMap(id -> document.find(id).stream())
                .map(Uml14Element::name)
                .filter(name -> !name.isEmpty())
                .toList();
    }

    private void find(String property, String id, Problems problems, List<Uml14Element> found) {
        if (document.isAmbiguous(id)) {
            problems.add(
                    line(),
                    property + " of " + type() + " " + label() + " refers to the id " + Problems.quote(id)
                            + ", which several elements have; give each an id of its own");
        } else {
            document.find(id)
                    .ifPresentOrElse(
                            found::add,
                            () -> problems.add(
                                    line(),
                                    property + " of " + type() + " " + label() + " refers to the unknown id "
                                            + Problems.quote(id)
                                            + "; export the model again, or correct the id"));
        }
    }

    @Override
    public String file() {
        return document.file();
    }
}
