package org.evoloop.xmi.scxml;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * The attributes and elements allowed in each element. Everything else is reported as a problem, so that nothing is
 * lost silently.
 */
final class ScxmlVocabulary {
    /** Namespaces of editors, which store positions and colors in the document. */
    private static final Pattern EDITORS = Pattern.compile(".*(qt\\.io|editor|scxmlgui|layout|viewmeta|graph|draw).*");

    private static final Map<String, Set<String>> KNOWN = Map.of(
            "scxml",
            Set.of(
                    "id",
                    "initial",
                    "initialstate",
                    "name",
                    "version",
                    "datamodel",
                    "binding",
                    "profile",
                    "exmode",
                    "state",
                    "parallel",
                    "final",
                    "script"),
            "state",
            Set.of(
                    "id",
                    "initial",
                    "final",
                    "state",
                    "parallel",
                    "history",
                    "transition",
                    "onentry",
                    "onexit",
                    "datamodel",
                    "invoke"),
            "parallel",
            Set.of("id", "state", "parallel", "transition", "onentry", "onexit", "datamodel", "invoke", "history"),
            "final",
            Set.of("id", "onentry", "onexit", "donedata"),
            "history",
            Set.of("id", "type", "transition"),
            "initial",
            Set.of("id", "transition"),
            "datamodel",
            Set.of("data"));

    private ScxmlVocabulary() {}

    /** Whether everything in the element is read, so that {@link #check} would report nothing. */
    static boolean understands(XmlNode node) {
        Set<String> known = KNOWN.getOrDefault(node.name(), Set.of());
        for (int i = 0; i < node.attributeCount(); i++) {
            if (!isKnown(node.attributeName(i), known)) {
                return false;
            }
        }
        List<XmlNode> children = node.children();
        for (int i = 0; i < children.size(); i++) {
            if (!isKnown(children.get(i), node.namespace(), known)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isKnown(String attribute, Set<String> known) {
        return known.contains(attribute) || attribute.indexOf(':') >= 0;
    }

    private static boolean isKnown(XmlNode child, String outer, Set<String> known) {
        return (isScxml(child, outer) && known.contains(child.name())) || isEditors(child);
    }

    /** Reports everything in the element that is not read. */
    static void check(XmlNode node, Problems problems) {
        check(
                node.name(),
                node.namespace(),
                () -> label(node),
                node.line(),
                node.attributeNames(),
                node.children(),
                problems);
    }

    /** Reports everything in the root that is not read. */
    static void check(ScxmlDocument document, Problems problems) {
        check(
                "scxml",
                document.namespace(),
                () -> "scxml",
                document.line(),
                document.attributes().keySet(),
                document.children(),
                problems);
    }

    private static void check(
            String name,
            String namespace,
            Supplier<String> label,
            int line,
            Collection<String> attributes,
            List<XmlNode> children,
            Problems problems) {
        Set<String> known = KNOWN.getOrDefault(name, Set.of());
        for (String attribute : attributes) {
            if (!isKnown(attribute, known)) {
                problems.add(
                        line,
                        "attribute " + attribute + " of " + label.get() + " is not supported; "
                                + ScxmlOwn.remedy(name, attribute));
            }
        }
        for (XmlNode child : children) {
            if (!isKnown(child, namespace, known)) {
                problems.add(
                        child.line(),
                        "element " + child.name() + " in " + label.get() + " is not supported; remove it");
            }
        }
    }

    /** Some documents use the namespace of the root, some that of SCXML's elements. */
    private static boolean isScxml(XmlNode child, String outer) {
        return child.namespace().equals(outer) || child.namespace().endsWith("/scxml");
    }

    /** Whether this is an editor's own data. */
    static boolean isEditors(XmlNode node) {
        return EDITORS.matcher(node.namespace().toLowerCase(Locale.ROOT)).matches();
    }

    /** For messages. */
    static String label(XmlNode node) {
        String id = node.attribute("id").strip();
        return id.isEmpty() ? node.name() + " in line " + node.line() : node.name() + " " + Problems.quote(id);
    }
}
