package org.evoloop.xmi.dialect;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.xml.namespace.QName;

/**
 * The beginning of a document, which identifies the tool that wrote it.
 *
 * @param root the root element
 * @param attributes the root's attributes, by name with prefix as written
 * @param namespaces the namespaces that the root declares
 * @param version the root's version of XMI, empty if it has none
 * @param exporter the writing tool's name for itself, empty if none
 * @param line the root's line
 */
public record XmiHead(
        QName root, Map<String, String> attributes, Set<String> namespaces, String version, String exporter, int line) {
    public XmiHead {
        attributes = Map.copyOf(attributes);
        namespaces = Set.copyOf(namespaces);
    }

    /**
     * Reads the root's start tag and the header. Leaves the stream at the header's end, at the first other start tag
     * ({@code isStartElement}), or at the root's end if that is empty.
     */
    public static XmiHead read(XmiStream stream) {
        stream.nextElementWithin(0);
        int line = stream.line();
        QName root = stream.getName();
        Map<String, String> attributes = new HashMap<>();
        for (int i = 0; i < stream.getAttributeCount(); i++) {
            attributes.put(XmlNode.attributeName(stream, i), stream.getAttributeValue(i));
        }
        Set<String> namespaces = new HashSet<>();
        for (int i = 0; i < stream.getNamespaceCount(); i++) {
            namespaces.add(String.valueOf(stream.getNamespaceURI(i)));
        }
        // XMI 1.x writes xmi.version, XMI 2.x xmi:version.
        String version =
                root.getNamespaceURI().isEmpty() ? stream.attribute("xmi.version") : stream.attribute("version");
        String exporter = "";
        if (stream.nextElementWithin(1)) {
            exporter = stream.attribute("exporter");
            if (stream.at("", "XMI.header")) {
                while (stream.nextElementWithin(2)) {
                    if (stream.at("", "XMI.exporter")) {
                        exporter = stream.getElementText().strip();
                    }
                }
            }
        }
        return new XmiHead(root, attributes, namespaces, version, exporter, line);
    }

    /** The root without its children. */
    public XmlNode node() {
        List<String> pairs = new ArrayList<>();
        attributes.forEach((name, value) -> pairs.addAll(List.of(name, value)));
        return new XmlNode(root, line, pairs);
    }

    /** For messages. */
    @Override
    public String toString() {
        return "root element " + Problems.quote(root.toString())
                + (version.isEmpty() ? "" : " of version " + Problems.quote(version))
                + (exporter.isEmpty() ? "" : " written by " + Problems.quote(exporter));
    }
}
