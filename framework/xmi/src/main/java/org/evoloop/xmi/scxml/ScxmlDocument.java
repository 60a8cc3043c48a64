package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * The contents of a document.
 *
 * <p>Threading: immutable.
 *
 * @param namespace of the root
 * @param attributes of the root
 * @param line of the root
 * @param children of the root
 * @param strayTextLine the line of a text in the root; 0 if there is none
 */
record ScxmlDocument(
        String file,
        String namespace,
        Map<String, String> attributes,
        int line,
        List<XmlNode> children,
        int strayTextLine) {

    /** @param stream positioned as {@link XmiHead#read} leaves it */
    static ScxmlDocument read(XmiHead head, XmiStream stream) {
        List<XmlNode> children = new ArrayList<>();
        boolean more = stream.isStartElement() || stream.nextElementWithin(0);
        while (more) {
            children.add(XmlNode.read(stream, inner -> false));
            more = stream.nextElementWithin(0);
        }
        return new ScxmlDocument(
                stream.file(),
                head.root().getNamespaceURI(),
                head.attributes(),
                head.line(),
                List.copyOf(children),
                stream.strayTextLine());
    }

    /** A copy in which each child is replaced, or removed for null. */
    ScxmlDocument with(Function<XmlNode, @Nullable XmlNode> replacement) {
        List<XmlNode> others = children.stream()
                .<XmlNode>mapMulti((child, kept) ->
                        Optional.ofNullable(replacement.apply(child)).ifPresent(kept))
                .toList();
        return new ScxmlDocument(file, namespace, attributes, line, others, strayTextLine);
    }

    /** An attribute of the root; empty if there is none. */
    String attribute(String name) {
        return attributes.getOrDefault(name, "");
    }
}
