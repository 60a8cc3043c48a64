package org.evoloop.xmi.uml14;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.evoloop.xmi.dialect.Condition;
import org.evoloop.xmi.dialect.Problems;

/** The texts of triggers, guards and actions. */
final class Uml14Texts {
    /** A text that already begins with a keyword of a time or change trigger. */
    private static final Pattern SAYS_SO = Pattern.compile("(?i)(after|at|tm|when)\\b.*", Pattern.DOTALL);

    private final Problems problems;

    Uml14Texts(Problems problems) {
        this.problems = problems;
    }

    /** The names of the events in this role, without repetition. */
    List<String> events(Uml14Element owner, String role) {
        List<String> names = new ArrayList<>();
        for (Uml14Element event : owner.all(role, problems)) {
            String name = event(event);
            if (name.isEmpty()) {
                problems.add(
                        event.line(),
                        "the " + event.type() + " " + event.label() + " that triggers " + owner.type() + " "
                                + owner.label() + " has no name; give it one");
            } else {
                names.add(name);
            }
        }
        return names.stream().distinct().toList();
    }

    private String event(Uml14Element event) {
        return switch (event.type()) {
            case "TimeEvent" -> prefixed("after ", expression(event, "when"), event.name());
            case "ChangeEvent" -> prefixed("when ", expression(event, "changeExpression"), event.name());
            case "SignalEvent" -> nameOr(event, "signal");
            case "CallEvent" -> nameOr(event, "operation");
            default -> event.name().isEmpty() ? wrapped(event) : event.name();
        };
    }

    /** Rational XDE wraps a transition's event into a namespace inside an event without a name. */
    private String wrapped(Uml14Element event) {
        return event.owned("namespace").stream()
                .flatMap(namespace -> namespace.owned("ownedElement").stream())
                .map(this::event)
                .findFirst()
                .orElse("");
    }

    private static String prefixed(String word, String text, String name) {
        String said = text.isEmpty() ? name : text;
        return said.isEmpty() || SAYS_SO.matcher(said).matches() || (text.isEmpty() && !name.isEmpty())
                ? said
                : word + said;
    }

    /** The name that the author sees on the transition, or else the name of the signal or operation. */
    private String nameOr(Uml14Element element, String role) {
        return element.name().isEmpty()
                ? element.all(role, problems).stream()
                        .map(Uml14Element::name)
                        .findFirst()
                        .orElse("")
                : element.name();
    }

    /** The condition of a transition; empty for none. */
    String guard(Uml14Element transition) {
        List<Uml14Element> guards = transition.all("guard", problems);
        if (guards.size() > 1) {
            problems.add(
                    transition.line(),
                    "transition " + transition.label() + " has " + guards.size() + " guards; join them into one");
        }
        if (guards.isEmpty()) {
            return "";
        }
        Uml14Element guard = guards.get(0);
        String text = expression(guard, "expression");
        if (text.isEmpty()) {
            text = guard.type().endsWith("Expression") ? guard.text("body").strip() : guard.name();
        }
        return Condition.guard(text);
    }

    private String expression(Uml14Element owner, String role) {
        return owner.all(role, problems).stream()
                .map(expression -> expression.text("body").strip())
                .filter(text -> !text.isEmpty())
                .findFirst()
                .orElse("");
    }

    /** The actions in this role, in order; an action without any text is left out. */
    List<String> actions(Uml14Element owner, String role) {
        List<String> texts = new ArrayList<>();
        owner.all(role, problems).forEach(action -> action(action, texts));
        return texts;
    }

    private void action(Uml14Element action, List<String> texts) {
        List<Uml14Element> sequence = action.all("action", problems);
        sequence.forEach(part -> action(part, texts));
        String text = expression(action, "script");
        if (text.isEmpty()) {
            text = expression(action, "expression");
        }
        if (text.isEmpty() && sequence.isEmpty()) {
            text = nameOr(action, action.type().equals("SendAction") ? "signal" : "operation");
        }
        if (!text.isEmpty()) {
            texts.add(text);
        }
    }
}
