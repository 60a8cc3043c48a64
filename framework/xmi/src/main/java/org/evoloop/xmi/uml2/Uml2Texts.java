package org.evoloop.xmi.uml2;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.xmi.dialect.Condition;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/** The texts of expressions, guards and behaviors, which the converter's author binds to code. */
final class Uml2Texts {
    /** Types that contain only a body. */
    private static final Set<String> OPAQUE = Set.of("OpaqueBehavior", "FunctionBehavior", "");

    private final Uml2References references;
    private final Problems problems;
    private final Set<String> guardIds = new HashSet<>();

    Uml2Texts(Uml2References references, Problems problems) {
        this.references = references;
        this.problems = problems;
    }

    /** The behaviors in this role, each by its code or else its name; one without any text is left out with a note. */
    List<String> behaviors(Uml2Element owner, String role) {
        List<String> texts = new ArrayList<>();
        for (Uml2Element behavior : references.all(owner, role)) {
            String text = behavior(behavior);
            if (!text.isEmpty()) {
                texts.add(text);
            } else if (!OPAQUE.contains(behavior.type())) {
                problems.add(
                        behavior.place(),
                        role + " of " + owner.type() + " " + owner.label() + " is a " + behavior.type() + " (id "
                                + Problems.quote(behavior.id()) + ") without a name; give it one");
            } else {
                problems.note(
                        behavior.place(),
                        role + " of " + owner.type() + " " + owner.label() + " has neither a body nor a name and is"
                                + " ignored; write what it does, or remove it");
            }
        }
        return texts;
    }

    private String behavior(Uml2Element behavior) {
        String body = body(behavior).orElse("");
        if (!body.isEmpty()) {
            return body;
        }
        if (!behavior.name().isEmpty()) {
            return behavior.name();
        }
        return references.all(behavior, "specification").stream()
                .map(Uml2Element::name)
                .findFirst()
                .orElse("");
    }

    /** The first body that is not blank; the others say the same in other languages. Nothing if there is no body. */
    private static Optional<String> body(Uml2Element element) {
        Stream<String> bodies = Stream.concat(
                element.node().attributeNames().contains("body") ? Stream.of(element.attribute("body")) : Stream.of(),
                element.node().children("body").stream().map(Uml2Texts::text));
        List<String> texts = bodies.map(String::strip).toList();
        return texts.isEmpty()
                ? Optional.empty()
                : Optional.of(texts.stream()
                        .filter(text -> !text.isEmpty())
                        .findFirst()
                        .orElse(""));
    }

    private static String text(XmlNode node) {
        return node.text().isEmpty() ? node.attribute("xmi:value") : node.text();
    }

    /** The condition of a transition; empty for none. */
    String guard(Uml2Element transition) {
        // Visual Paradigm writes the guard inside the transition, and repeats part of it in an attribute.
        List<Uml2Element> constraints = new ArrayList<>(references.inside(transition, "guard"));
        if (constraints.isEmpty()) {
            constraints.addAll(references.all(transition, "guard"));
        }
        constraints.addAll(references.all(transition, "preCondition"));
        if (constraints.size() > 1) {
            problems.add(
                    transition.place(),
                    "transition " + transition.label() + " has " + constraints.size() + " guards; join them into one");
        }
        return constraints.isEmpty() ? "" : guardText(constraints.get(0));
    }

    /** Whether this constraint was read as a guard. */
    boolean isGuard(Uml2Element constraint) {
        return guardIds.contains(constraint.id());
    }

    private String guardText(Uml2Element constraint) {
        Uml2Vocabulary.check(constraint, problems);
        guardIds.add(constraint.id());
        String text = constraint(constraint);
        if (text.isEmpty()) {
            problems.note(
                    constraint.place(),
                    "guard " + constraint.label() + " has no text and is ignored; write the condition, or remove it");
        }
        if (Condition.isFalse(text)) {
            problems.note(
                    constraint.place(),
                    "guard " + constraint.label()
                            + " is false, so its transition is never taken; write the condition, or"
                            + " remove the transition");
        }
        return Condition.guard(text);
    }

    /** The text of a constraint, or else its name. */
    String constraint(Uml2Element constraint) {
        String text = specification(constraint).strip();
        return text.isEmpty() ? constraint.name() : text;
    }

    private String specification(Uml2Element constraint) {
        String attribute = constraint.attribute("specification");
        if (!attribute.isEmpty() && constraint.document().find(attribute).isEmpty()) {
            // StarUML writes the text in place of an id.
            return attribute;
        }
        return references.one(constraint, "specification").map(this::expression).orElse("");
    }

    /** The text of a value specification; empty if it has none. */
    String expression(Uml2Element value) {
        return switch (value.type()) {
            case "LiteralBoolean" -> value(value).orElse("false");
            case "LiteralInteger", "LiteralUnlimitedNatural", "LiteralReal" ->
                value(value).orElse("0");
            case "LiteralString" -> value(value).orElse("");
            case "Expression", "StringExpression" -> operation(value);
            case "TimeExpression", "Duration", "TimeInterval", "DurationInterval" ->
                nested(value, "expr").or(() -> body(value)).orElseGet(value::name);
            case "OpaqueExpression", "" ->
                body(value)
                        .or(() -> value(value))
                        .filter(text -> !text.isEmpty())
                        .orElseGet(value::name);
            default -> unknown(value);
        };
    }

    private Optional<String> nested(Uml2Element value, String role) {
        List<Uml2Element> found = references.all(value, role);
        return found.isEmpty()
                ? Optional.empty()
                : Optional.of(found.stream().map(this::expression).collect(Collectors.joining(", ")));
    }

    private String operation(Uml2Element value) {
        String symbol = value.attribute("symbol").isEmpty() ? value.name() : value.attribute("symbol");
        return nested(value, "operand")
                .map(operands -> symbol + "(" + operands + ")")
                .orElse(symbol);
    }

    private static Optional<String> value(Uml2Element value) {
        return value.node().attributeNames().contains("value")
                ? Optional.of(value.attribute("value"))
                : value.node().child("value").map(Uml2Texts::text);
    }

    private String unknown(Uml2Element value) {
        problems.add(
                value.place(),
                "value of type " + value.type() + " " + value.label()
                        + " is not supported; write it as an opaque expression");
        return "";
    }
}
