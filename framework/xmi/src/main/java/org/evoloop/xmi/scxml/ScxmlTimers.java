package org.evoloop.xmi.scxml;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * Reads events that a document sends to itself after a delay. If a state sends one on entry, and only transitions of
 * that state take it, then it is the state's timer, and those transitions get a time trigger in its place. Every
 * other one is refused, since a state machine has no other timers.
 */
final class ScxmlTimers {
    private static final Set<String> NAMES = Set.of("send", "cancel");
    private static final Pattern DELAY = Pattern.compile("\\+?([0-9]*\\.?[0-9]+)\\s*([A-Za-z]*)");
    private static final Pattern QUOTED = Pattern.compile("'([^']*)'|\"([^\"]*)\"");
    private static final Set<String> OWN_PROCESSOR =
            Set.of("", "scxml", "http://www.w3.org/TR/scxml/#SCXMLEventProcessor");
    private static final Set<String> READ = Set.of("id", "sendid", "event", "delay", "delayexpr", "type", "target");

    private final ScxmlDocument document;
    private final Problems problems;
    private final List<ScxmlContent> contents;
    /** The elements that are read as something else. */
    private final Set<XmlNode> replaced = new HashSet<>();

    private final Map<XmlNode, XmlNode> outer = new HashMap<>();
    private final List<Timer> timers = new ArrayList<>();

    private record Timer(XmlNode state, XmlNode send, String event, String trigger) {
        String id() {
            return send.attribute("id") + send.attribute("sendid");
        }
    }

    private ScxmlTimers(ScxmlDocument document, List<ScxmlContent> contents, Problems problems) {
        this.document = document;
        this.contents = contents;
        this.problems = problems;
    }

    /** The document with time triggers in place of its timers. */
    static ScxmlDocument read(ScxmlDocument document, Problems problems) {
        List<ScxmlContent> contents = ScxmlContent.all(null, document.children(), NAMES);
        return contents.isEmpty() ? document : new ScxmlTimers(document, contents, problems).read();
    }

    private ScxmlDocument read() {
        document.children().forEach(this::rememberOuter);
        for (ScxmlContent content : contents) {
            XmlNode element = content.element();
            if (element.name().equals("send") && isDelayed(element)) {
                delayed(content);
            }
        }
        if (timers.isEmpty()) {
            return document;
        }
        contents.stream()
                .filter(content -> content.element().name().equals("cancel"))
                .forEach(this::cancel);
        timers.forEach(this::noteWithoutCancel);
        return document.with(this::tidy);
    }

    private void rememberOuter(XmlNode node) {
        for (XmlNode child : node.children()) {
            outer.put(child, node);
            rememberOuter(child);
        }
    }

    private static boolean isDelayed(XmlNode send) {
        return !send.attribute("delay").isBlank()
                || !send.attribute("delayexpr").isBlank();
    }

    private void delayed(ScxmlContent content) {
        XmlNode send = content.element();
        String event = send.attribute("event").strip();
        String trigger = trigger(send);
        String reason = notATimer(content, event, trigger);
        if (reason.isEmpty()) {
            timers.add(new Timer(requireNonNull(content.state()), send, event, trigger));
            replaced.add(send);
        } else {
            problems.add(
                    send.line(),
                    content.label() + " is not the timer of a state, since " + reason + "; write event=\""
                            + (trigger.isEmpty() ? "after 2 s" : trigger)
                            + "\" on the transition of the state that waits, in place of " + Problems.quote(event));
        }
    }

    /** The time trigger for the delay; empty if that is computed. */
    private static String trigger(XmlNode send) {
        Matcher quoted = QUOTED.matcher(send.attribute("delayexpr").strip());
        String delay = send.attribute("delay").strip();
        if (delay.isEmpty() && quoted.matches()) {
            delay = quoted.group(1) == null ? quoted.group(2) : quoted.group(1);
        }
        Matcher matcher = DELAY.matcher(delay.strip());
        if (!matcher.matches()) {
            return "";
        }
        String number = matcher.group(1).startsWith(".") ? "0" + matcher.group(1) : matcher.group(1);
        // Some interpreters know minutes by this name, too.
        String unit = matcher.group(2).equals("m") ? "min" : matcher.group(2);
        return ("after " + number + " " + unit).strip();
    }

    /** Why this is not the timer of its state; empty if it is. */
    private String notATimer(ScxmlContent content, String event, String trigger) {
        XmlNode send = content.element();
        XmlNode state = content.state();
        if (event.isEmpty()) {
            return "it names no event";
        }
        if (trigger.isEmpty()) {
            return "its delay is not a number with a unit";
        }
        if (state == null || !content.isAlwaysIn("onentry")) {
            return "it is not always run when a state is entered";
        }
        if (!OWN_PROCESSOR.contains(send.attribute("type").strip())
                || !send.attribute("target").isBlank()) {
            return "it goes to somebody else";
        }
        if (!send.children().isEmpty()
                || send.attributeNames().stream().anyMatch(name -> name.indexOf(':') < 0 && !READ.contains(name))) {
            return "it carries more than its event";
        }
        List<XmlNode> takers = ScxmlEvents.takers(document.children(), event).stream()
                .filter(taker -> ScxmlEvents.names(taker, event))
                .toList();
        if (takers.stream().noneMatch(taker -> outer.get(taker) == state)) {
            return "no transition of " + ScxmlVocabulary.label(state) + " takes its event";
        }
        return takers.stream()
                .map(taker -> requireNonNull(outer.get(taker)))
                .filter(taker -> !sends(taker, event))
                .findFirst()
                .map(other -> ScxmlVocabulary.label(other) + " takes its event, too")
                .orElse("");
    }

    /** Whether a state sends this event itself when it is entered. */
    private boolean sends(XmlNode state, String event) {
        return contents.stream()
                .anyMatch(content -> content.state() == state
                        && content.isAlwaysIn("onentry")
                        && content.element().name().equals("send")
                        && isDelayed(content.element())
                        && content.element().attribute("event").strip().equals(event));
    }

    private void cancel(ScxmlContent content) {
        XmlNode cancel = content.element();
        String id = cancel.attribute("sendid").strip();
        List<Timer> cancelled =
                timers.stream().filter(timer -> timer.id().equals(id)).toList();
        if (cancelled.isEmpty() && !id.isEmpty()) {
            return;
        }
        if (cancelled.stream().anyMatch(timer -> isOver(timer, content))) {
            replaced.add(cancel);
        } else {
            problems.add(
                    cancel.line(),
                    content.label()
                            + (id.isEmpty() ? " does not name the timer" : " ends a timer while its state lasts")
                            + ", which is not supported; cancel it by its id in onexit of its state");
        }
    }

    /** Whether a timer has not begun or has ended anyway where this is run. */
    private boolean isOver(Timer timer, ScxmlContent content) {
        XmlNode state = content.state();
        boolean around = state != null && isWithin(timer.state(), state);
        if (content.block().name().equals("onexit")) {
            return around;
        }
        if (content.block().name().equals("onentry")) {
            return state == timer.state();
        }
        String targets = content.block().attribute("target").strip();
        boolean related = around || (state != null && isWithin(state, timer.state()));
        boolean internal = content.block().attribute("type").equals("internal");
        return related && !internal && !targets.isEmpty() && !targetsIn(timer.state(), targets);
    }

    private boolean isWithin(XmlNode inner, XmlNode state) {
        XmlNode at = inner;
        while (at != null && at != state) {
            at = outer.get(at);
        }
        return at != null;
    }

    /** Whether one of these ids is in a state. */
    private static boolean targetsIn(XmlNode state, String ids) {
        Set<String> wanted = Set.of(ids.split("\\s+", -1));
        return state.children().stream()
                .anyMatch(child -> wanted.contains(child.attribute("id").strip()) || targetsIn(child, ids));
    }

    private void noteWithoutCancel(Timer timer) {
        boolean cancelled = contents.stream()
                .map(ScxmlContent::element)
                .anyMatch(element -> element.name().equals("cancel")
                        && replaced.contains(element)
                        && element.attribute("sendid").strip().equals(timer.id()));
        if (!cancelled) {
            problems.note(
                    timer.send().line(),
                    "send of " + Problems.quote(timer.event()) + " is read as the timer "
                            + Problems.quote(timer.trigger())
                            + " of " + ScxmlVocabulary.label(timer.state())
                            + ", which ends when that is left, though SCXML would deliver it later, too; cancel it in "
                            + "onexit if that is meant");
        }
    }

    private @Nullable XmlNode tidy(XmlNode node) {
        if (replaced.contains(node)) {
            return null;
        }
        XmlNode tidy = node.withChildren(this::tidy);
        String event = node.name().equals("transition") ? node.attribute("event") : "";
        String timed = event.isEmpty() ? "" : timed(event, requireNonNull(outer.get(node)));
        return timed.equals(event) ? tidy : tidy.with("event", timed);
    }

    /** A transition's descriptors, with the triggers of its state's timers in place of the events that they raise. */
    private String timed(String event, XmlNode state) {
        List<String> drawn = ScxmlEvents.descriptors(event);
        Set<String> descriptors = new LinkedHashSet<>(drawn);
        for (Timer timer : timers) {
            if (timer.state() == state && drawn.stream().anyMatch(word -> ScxmlEvents.matches(word, timer.event()))) {
                descriptors.add(timer.trigger());
                if (!isSentOtherwise(timer.event())) {
                    descriptors.remove(timer.event());
                }
            }
        }
        return String.join(" ", descriptors);
    }

    private boolean isSentOtherwise(String event) {
        return contents.stream()
                .map(ScxmlContent::element)
                .anyMatch(element -> element.name().equals("send")
                        && !replaced.contains(element)
                        && element.attribute("event").strip().equals(event));
    }
}
