package org.evoloop.xmi.scxml;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/** Reports texts and values that would get lost, besides what {@link ScxmlVocabulary} reports. */
final class ScxmlLosses {
    /** Elements whose text is not read, because they hold other elements. */
    private static final Set<String> WITHOUT_TEXT =
            Set.of("state", "parallel", "final", "history", "initial", "datamodel", "raise", "cancel");

    private static final Set<String> BLOCKS = Set.of("onentry", "onexit", "transition");
    /** What is in these is kept as it is. */
    private static final Set<String> KEPT = Set.of("invoke", "content", "donedata");

    private static final Map<String, Set<String>> ATTRIBUTES = Map.of(
            "onentry", Set.of(),
            "onexit", Set.of(),
            "transition", Set.of("event", "cond", "target", "type"),
            "raise", Set.of("event"),
            "assign", Set.of("location", "name", "expr"),
            "data", Set.of("id", "name", "expr", "src"));

    private static final Map<String, List<String>> TYPES =
            Map.of("transition", List.of("internal", "external"), "history", List.of("shallow", "deep"));

    private final Problems problems;

    private ScxmlLosses(Problems problems) {
        this.problems = problems;
    }

    /** Reports everything in the document that would get lost. */
    static void check(ScxmlDocument document, Problems problems) {
        ScxmlLosses losses = new ScxmlLosses(problems);
        if (document.strayTextLine() > 0) {
            problems.add(document.strayTextLine(), "text in scxml means nothing; remove it");
        }
        ScxmlOwn.check(document, problems);
        document.children().forEach(child -> losses.check(child, "scxml"));
    }

    /** @param where the innermost vertex around the element */
    private void check(XmlNode node, String where) {
        if (ScxmlVocabulary.isEditors(node) || KEPT.contains(node.name())) {
            return;
        }
        ScxmlOwn.check(node, problems);
        text(node, where);
        value(node, where);
        attributes(node, where);
        if (node.name().equals("transition")) {
            events(node, where);
        } else if (node.name().equals("state")) {
            initial(node);
        }
        // Most elements have no children, and a label for each of a hundred thousand would be garbage.
        if (!node.children().isEmpty()) {
            boolean vertex =
                    WITHOUT_TEXT.contains(node.name()) && !node.attribute("id").isBlank();
            String inner = vertex ? ScxmlVocabulary.label(node) : where;
            node.children().forEach(child -> check(child, inner));
        }
    }

    private void text(XmlNode node, String where) {
        String text = node.text();
        if (text.isEmpty()) {
            return;
        }
        if (BLOCKS.contains(node.name())) {
            problems.add(
                    node.line(),
                    "text " + Problems.quote(text) + " in " + node.name() + " of " + where
                            + " is not an action; write <script>" + (text.length() > 40 ? "..." : text) + "</script>");
        } else if (WITHOUT_TEXT.contains(node.name())) {
            problems.add(
                    node.line(),
                    "text " + Problems.quote(text) + " in " + ScxmlVocabulary.label(node)
                            + " means nothing; remove it");
        }
    }

    /** An element that takes its value from an attribute or from its contents has only one of them. */
    private void value(XmlNode node, String where) {
        List<String> sources = switch (node.name()) {
            case "assign" -> List.of("expr");
            case "data" -> List.of("expr", "src");
            case "script" -> List.of("src");
            default -> List.of();
        };
        boolean attribute =
                sources.stream().anyMatch(source -> !node.attribute(source).isEmpty());
        if (attribute && !(node.text().isEmpty() && node.children().isEmpty())) {
            problems.add(
                    node.line(),
                    node.name() + " of " + where + " has a value in an attribute and another in it; keep one");
        }
    }

    private void attributes(XmlNode node, String where) {
        List<String> types = TYPES.getOrDefault(node.name(), List.of());
        String type = node.attribute("type");
        if (!types.isEmpty() && !type.isEmpty() && !types.contains(type)) {
            problems.add(
                    node.line(),
                    node.name() + " of " + where + " is of the unknown type " + Problems.quote(type) + "; use "
                            + String.join(" or ", types));
        }
        Set<String> known = ATTRIBUTES.get(node.name());
        for (int i = 0; known != null && i < node.attributeCount(); i++) {
            String name = node.attributeName(i);
            if (name.indexOf(':') < 0 && !known.contains(name)) {
                problems.add(
                        node.line(),
                        "attribute " + name + " of " + node.name() + " of " + where + " is not supported; remove it");
            }
        }
    }

    private void events(XmlNode transition, String where) {
        String event = transition.attribute("event");
        if (event.indexOf(',') >= 0 || event.indexOf(';') >= 0) {
            ScxmlEvents.descriptors(event).stream()
                    .filter(descriptor -> descriptor.endsWith(",") || descriptor.endsWith(";"))
                    .forEach(descriptor -> problems.add(
                            transition.line(),
                            "event " + Problems.quote(descriptor) + " of transition of " + where
                                    + " ends in a separator; put only a blank between two events"));
        }
    }

    private void initial(XmlNode state) {
        boolean initial =
                !state.attribute("initial").isBlank() || state.child("initial").isPresent();
        if (initial && state.children().stream().noneMatch(ScxmlTree::isVertex)) {
            problems.add(
                    state.line(),
                    "initial of " + ScxmlVocabulary.label(state)
                            + " leads nowhere, since the state holds no other; remove it");
        }
    }
}
