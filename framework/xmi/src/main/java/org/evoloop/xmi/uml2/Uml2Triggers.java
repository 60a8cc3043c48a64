package org.evoloop.xmi.uml2;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.xmi.dialect.Problems;

/** Finds the names of the events that trigger something. */
final class Uml2Triggers {
    /** A text that is already a time or change trigger: it begins with a keyword, or is a duration of ISO 8601. */
    private static final Pattern SAYS_SO = Pattern.compile("(?i:(after|at|tm|when)\\b.*)|PT?[0-9].*", Pattern.DOTALL);

    /** Such as {@code at 2 s}, while {@code at 12:00} is a point in time. */
    private static final Pattern DELAY = Pattern.compile("at [0-9]+([.,][0-9]+)?\\s*(\\p{L}+)?");

    /** Names that only mean any event. */
    private static final Pattern ANY = Pattern.compile("(?i)(AnyReceiveEvent\\d*|all|any|\\*)?");

    private final Uml2References references;
    private final Uml2Texts texts;
    private final Problems problems;

    Uml2Triggers(Uml2References references, Uml2Texts texts, Problems problems) {
        this.references = references;
        this.texts = texts;
        this.problems = problems;
    }

    /** The names of the events in this role, in the file's order, without repetition. */
    List<String> names(Uml2Element owner, String role) {
        List<String> names = new ArrayList<>();
        for (Uml2Element trigger : references.all(owner, role)) {
            String name = name(trigger);
            if (!name.isEmpty()) {
                names.add(name);
            } else {
                problems.add(
                        trigger.place(),
                        "trigger " + trigger.label() + " of " + owner.type() + " " + owner.label()
                                + " names no event; give it an event or a name");
            }
        }
        return names.stream().distinct().toList();
    }

    private String name(Uml2Element trigger) {
        if (!trigger.type().equals("Trigger")) {
            // UML 2.0 had a kind of trigger for each kind of event; StarUML puts the event itself here.
            return eventName(trigger, trigger);
        }
        Uml2Vocabulary.check(trigger, problems);
        String name = references
                .one(trigger, "event")
                .map(event -> eventName(event, trigger))
                .orElse(trigger.name());
        String ports = references.all(trigger, "port").stream()
                .map(port -> port.name().isEmpty() ? port.id() : port.name())
                .collect(Collectors.joining(", "));
        return ports.isEmpty() ? name : name + " from " + ports;
    }

    private String eventName(Uml2Element event, Uml2Element trigger) {
        String own = event.name().isEmpty() ? trigger.name() : event.name();
        return switch (event.type()) {
            case "SignalEvent", "ReceiveSignalEvent", "SendSignalEvent", "SignalTrigger" -> named(event, "signal", own);
            case "CallEvent", "ReceiveOperationEvent", "SendOperationEvent", "CallTrigger" ->
                named(event, "operation", own);
            case "TimeEvent", "TimeTrigger" -> time(event, own);
            case "ChangeEvent", "ChangeTrigger" -> expression(event, "changeExpression", "when ", own);
            case "AnyReceiveEvent", "AnyTrigger" -> any(event, trigger);
            default -> own;
        };
    }

    /** A delay without isRelative would be an event that no timer raises. */
    private String time(Uml2Element event, String own) {
        boolean relative = event.attribute("isRelative").equals("true");
        String name = expression(event, "when", relative ? "after " : "at ", own);
        if (!relative && DELAY.matcher(name).matches()) {
            problems.add(
                    event.place(),
                    "time event " + event.label() + " has the delay " + Problems.quote(name.substring("at ".length()))
                            + ", but isRelative is not true; set it to true, or write after in the expression");
        }
        return name;
    }

    private String named(Uml2Element event, String role, String own) {
        return references
                .one(event, role)
                .map(Uml2Element::name)
                .filter(name -> !name.isEmpty())
                .orElse(own);
    }

    /** The text of the expression in this role, with {@code prefix} unless it already has such a keyword. */
    private String expression(Uml2Element event, String role, String prefix, String own) {
        return references
                .one(event, role)
                .map(texts::expression)
                .map(String::strip)
                .filter(text -> !text.isEmpty())
                .map(text -> SAYS_SO.matcher(text).matches() ? text : prefix + text)
                .orElse(own);
    }

    private String any(Uml2Element event, Uml2Element trigger) {
        String name = ANY.matcher(event.name()).matches() ? trigger.name() : event.name();
        // StarUML writes every event without another kind as an AnyReceiveEvent.
        if (event.document().isBy("StarUML") || !ANY.matcher(name).matches()) {
            return name;
        }
        problems.add(
                trigger.place(),
                "trigger " + trigger.label() + " receives any event, which is not supported; name the events");
        // Any name will do; the problem has been reported.
        return "any";
    }
}
