package org.evoloop.xmi.scxml;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * Reads events that a document raises and takes before all others. If a simple state raises one on entry and always
 * leaves on it, it leaves at once, as by a transition without an event. Every other one is refused: no code can imitate
 * it.
 */
final class ScxmlRaises {
    private static final Set<String> NAMES = Set.of("raise");

    private final ScxmlDocument document;
    private final Problems problems;
    private final Set<XmlNode> removed = new HashSet<>();
    private final Set<XmlNode> atOnce = new HashSet<>();

    private ScxmlRaises(ScxmlDocument document, Problems problems) {
        this.document = document;
        this.problems = problems;
    }

    /** The document without raised events. */
    static ScxmlDocument read(ScxmlDocument document, Problems problems) {
        List<ScxmlContent> raises = ScxmlContent.all(null, document.children(), NAMES);
        if (raises.isEmpty()) {
            return document;
        }
        ScxmlRaises reading = new ScxmlRaises(document, problems);
        raises.forEach(raise -> reading.read(raise, raises));
        return document.with(reading::tidy);
    }

    private void read(ScxmlContent raise, List<ScxmlContent> raises) {
        XmlNode element = raise.element();
        String event = element.attribute("event").strip();
        boolean alone =
                raises.stream().filter(other -> other.state() == raise.state()).count() == 1;
        Optional<XmlNode> leaving = alone ? leaving(raise, event) : Optional.empty();
        if (leaving.isPresent()) {
            atOnce.add(leaving.get());
            removed.add(element);
        } else if (ScxmlEvents.takers(document.children(), event).isEmpty()) {
            removed.add(element);
            problems.note(
                    element.line(),
                    raise.label() + " raises " + Problems.quote(event)
                            + ", which no transition takes, and is ignored; remove it");
        } else {
            problems.add(
                    element.line(),
                    raise.label() + " raises " + Problems.quote(event)
                            + " before all other events, which is not supported; give the transition that takes it no "
                            + "event, or let your code raise it: write <send event=\"" + event
                            + "\"/>, which is an effect");
        }
    }

    /** The transition that a simple state always takes as soon as it has raised the event on entry. */
    private Optional<XmlNode> leaving(ScxmlContent raise, String event) {
        XmlNode state = raise.state();
        boolean simple = state != null
                && state.name().equals("state")
                && state.children().stream().noneMatch(ScxmlTree::isVertex)
                && !hasParallel(document.children());
        if (state == null || !simple || !raise.isAlwaysIn("onentry")) {
            return Optional.empty();
        }
        List<XmlNode> transitions = state.children("transition");
        boolean waits = transitions.stream()
                .noneMatch(transition -> transition.attribute("event").isBlank());
        return transitions.stream()
                .filter(transition -> waits && ScxmlEvents.takes(transition, event))
                .findFirst()
                .filter(first -> first.attribute("cond").isBlank()
                        && !first.attribute("target").isBlank());
    }

    private static boolean hasParallel(List<XmlNode> children) {
        return children.stream().anyMatch(child -> child.name().equals("parallel") || hasParallel(child.children()));
    }

    private @Nullable XmlNode tidy(XmlNode node) {
        if (removed.contains(node)) {
            return null;
        }
        XmlNode tidy = node.withChildren(this::tidy);
        return atOnce.contains(node) ? tidy.with("event", "") : tidy;
    }
}
