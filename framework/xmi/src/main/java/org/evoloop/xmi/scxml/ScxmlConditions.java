package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.xmi.dialect.Condition;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * Reads conditions that say something by themselves, as in UML: {@code true} is no condition, {@code false} never holds,
 * and {@code else} holds if no other transition is taken. So {@code else} becomes no condition, after all others.
 */
final class ScxmlConditions {
    private final Problems problems;

    private ScxmlConditions(Problems problems) {
        this.problems = problems;
    }

    /** The document without such conditions, and without transitions that an earlier one of the same state repeats. */
    static ScxmlDocument read(ScxmlDocument document, Problems problems) {
        ScxmlConditions conditions = new ScxmlConditions(problems);
        return document.with(conditions::tidy);
    }

    private XmlNode tidy(XmlNode node) {
        return node.children().isEmpty() ? node : transitions(node.withChildren(this::tidy));
    }

    private XmlNode transitions(XmlNode state) {
        List<XmlNode> transitions = state.children("transition");
        if (transitions.stream()
                .noneMatch(transition -> transition.attributeNames().contains("cond"))) {
            return state;
        }
        List<XmlNode> kept = new ArrayList<>(state.children());
        List<XmlNode> last = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        for (XmlNode transition : transitions) {
            String condition = transition.attribute("cond").strip();
            boolean repeated = transition.attribute("event").isBlank() && !condition.isEmpty() && !taken.add(condition);
            if (Condition.isFalse(condition) || repeated) {
                kept.remove(transition);
                problems.note(
                        transition.line(),
                        "transition of " + ScxmlVocabulary.label(state) + " is never taken, since "
                                + (repeated
                                        ? "an earlier one has the same condition"
                                        : "its condition is " + Problems.quote(condition))
                                + ", and is ignored; remove it");
            } else if (Condition.isTrue(condition)) {
                kept.set(kept.indexOf(transition), transition.with("cond", ""));
            } else if (Condition.isElse(condition)) {
                kept.remove(transition);
                last.add(transition.with("cond", ""));
            }
        }
        kept.addAll(last);
        return state.as(state.name(), kept);
    }
}
