package org.evoloop.xmi.dialect;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import javax.xml.namespace.QName;
import javax.xml.stream.XMLStreamConstants;
import org.jspecify.annotations.Nullable;

/**
 * An element of a file with its contents, for dialects whose elements refer to each other. Dialects build it only for
 * the parts of a file that they need, within the limits of {@link XmiStream#keep}.
 *
 * <p>Attributes of any version of the XMI namespace are named {@code xmi:id}, {@code xmi:type} and so on, and those of
 * this project {@code evoloop:device} and so on. Attributes of other namespaces have the prefix used in the file. {@code
 * xsi:type} becomes {@code xmi:type}.
 *
 * <p>An element equals only itself.
 *
 * <p>Threading: immutable once read.
 */
public final class XmlNode {
    /** The prefix of this project's own attributes. */
    public static final String EVOLOOP = "evoloop:";

    private static final String EVOLOOP_NAMESPACE = "urn:evoloop";
    private static final String SCHEMA_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance";

    private final String namespace;
    private final String name;
    private final int line;
    /** Name, value, name, value and so on. Compact, since there may be a million of these. */
    private final String[] attributes;

    /** Most elements have none. */
    private List<XmlNode> children = List.of();

    private String text = "";

    private XmlNode(XmiStream stream) {
        this.namespace = text(stream.getNamespaceURI());
        this.name = stream.getLocalName();
        this.line = stream.line();
        int count = stream.getAttributeCount();
        this.attributes = new String[2 * count];
        int characters = 0;
        for (int i = 0; i < count; i++) {
            attributes[2 * i] = attributeName(stream, i);
            attributes[2 * i + 1] = stream.getAttributeValue(i);
            characters += attributes[2 * i + 1].length();
        }
        stream.keep(characters);
    }

    XmlNode(QName name, int line, List<String> attributes) {
        this.namespace = name.getNamespaceURI();
        this.name = name.getLocalPart();
        this.line = line;
        this.attributes = attributes.toArray(new String[0]);
    }

    private XmlNode(XmlNode from, String name, List<String> attributes, List<XmlNode> children) {
        this.namespace = from.namespace;
        this.name = name;
        this.line = from.line;
        this.attributes = attributes.toArray(new String[0]);
        this.children = List.copyOf(children);
        this.text = from.text;
    }

    /** A copy with another name and other children. */
    public XmlNode as(String otherName, List<XmlNode> otherChildren) {
        return new XmlNode(this, otherName, List.of(attributes), otherChildren);
    }

    /** A copy with another value of an attribute that it has. */
    public XmlNode with(String attribute, String value) {
        String[] changed = attributes.clone();
        for (int i = 0; i < changed.length; i += 2) {
            if (changed[i].equals(attribute)) {
                changed[i + 1] = value;
            }
        }
        return new XmlNode(this, name, List.of(changed), children);
    }

    /** A copy in which each child is replaced, or removed for null; itself if nothing changes. */
    public XmlNode withChildren(Function<XmlNode, @Nullable XmlNode> replacement) {
        List<XmlNode> others = null;
        for (int i = 0; i < children.size(); i++) {
            XmlNode child = children.get(i);
            XmlNode other = replacement.apply(child);
            if (other != child && others == null) {
                others = new ArrayList<>(children.subList(0, i));
            }
            if (other != null && others != null) {
                others.add(other);
            }
        }
        return others == null ? this : as(name, others);
    }

    /**
     * Creates an element that is not in a file.
     *
     * @param attributes names and values alternately
     * @param from the element whose line and namespace it gets
     */
    public static XmlNode made(XmlNode from, String name, List<String> attributes, List<XmlNode> children) {
        return new XmlNode(from, name, attributes, children);
    }

    /** Like {@link #attribute(String)}, for the element whose start tag is the current event. */
    public static String attribute(XmiStream stream, String wanted) {
        for (int i = 0; i < stream.getAttributeCount(); i++) {
            if (attributeName(stream, i).equals(wanted)) {
                return stream.getAttributeValue(i);
            }
        }
        return "";
    }

    /** The name of an attribute of the element whose start tag is the current event, as above. */
    static String attributeName(XmiStream stream, int index) {
        String uri = text(stream.getAttributeNamespace(index));
        String localName = stream.getAttributeLocalName(index);
        if (uri.isEmpty()) {
            return localName;
        }
        boolean xmi = isXmi(uri) || (uri.equals(SCHEMA_INSTANCE) && localName.equals("type"));
        String prefix = (xmi ? "xmi" : stream.getAttributePrefix(index)) + ':';
        return ((uri.equals(EVOLOOP_NAMESPACE) ? EVOLOOP : prefix) + localName).intern();
    }

    private static String text(@Nullable String text) {
        return text == null ? "" : text;
    }

    /** Whether this is the namespace of a version of XMI 2. */
    public static boolean isXmi(String uri) {
        return uri.contains("XMI");
    }

    /** The element whose start tag is the current event, without children; does not move the stream. */
    public static XmlNode alone(XmiStream stream) {
        return new XmlNode(stream);
    }

    /**
     * Reads the element whose start tag is the current event; leaves the stream at its end tag.
     *
     * @param unwanted decides at a start tag whether to skip that element
     */
    public static XmlNode read(XmiStream stream, Predicate<XmiStream> unwanted) {
        XmlNode node = new XmlNode(stream);
        List<XmlNode> children = null;
        int depth = stream.depth();
        // Most elements have no text.
        StringBuilder text = null;
        while (true) {
            switch (stream.next()) {
                case XMLStreamConstants.START_ELEMENT -> {
                    if (unwanted.test(stream)) {
                        stream.skipElement();
                    } else {
                        children = children == null ? new ArrayList<>() : children;
                        children.add(read(stream, unwanted));
                    }
                }
                case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA, XMLStreamConstants.SPACE -> {
                    if (!stream.isWhiteSpace()) {
                        stream.keep(stream.getTextLength());
                        text = text == null ? new StringBuilder() : text;
                        text.append(stream.getText());
                    }
                }
                case XMLStreamConstants.END_ELEMENT -> {
                    if (stream.depth() < depth) {
                        node.children = children == null ? List.of() : children;
                        node.text = text == null ? "" : text.toString().strip();
                        return node;
                    }
                }
                default -> {}
            }
        }
    }

    /** The namespace; empty if it has none. */
    public String namespace() {
        return namespace;
    }

    /** The local name. */
    public String name() {
        return name;
    }

    /** The line where its start tag ends, counted from 1. */
    public int line() {
        return line;
    }

    /** The element's own text, without that of its children, stripped. */
    public String text() {
        return text;
    }

    /** The attribute's value; empty if there is none. */
    public String attribute(String wanted) {
        for (int i = 0; i < attributes.length; i += 2) {
            if (attributes[i].equals(wanted)) {
                return attributes[i + 1];
            }
        }
        return "";
    }

    /** The number of attributes. */
    public int attributeCount() {
        return attributes.length / 2;
    }

    /** The name of an attribute. */
    public String attributeName(int index) {
        return attributes[2 * index];
    }

    /** The names of all attributes. */
    public List<String> attributeNames() {
        // A view, since callers iterate over it very often.
        return new AbstractList<>() {
            @Override
            public String get(int index) {
                return attributeName(index);
            }

            @Override
            public int size() {
                return attributeCount();
            }
        };
    }

    /** All child elements. */
    public List<XmlNode> children() {
        return children;
    }

    /** The child elements with this name. */
    public List<XmlNode> children(String wanted) {
        List<XmlNode> found = new ArrayList<>();
        for (XmlNode child : children) {
            if (child.name.equals(wanted)) {
                found.add(child);
            }
        }
        return found;
    }

    /** The first child element with this name. */
    public Optional<XmlNode> child(String wanted) {
        return children.stream().filter(child -> child.name.equals(wanted)).findFirst();
    }
}
