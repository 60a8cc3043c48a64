package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * Finds the events that a transition's descriptors match. {@code a} matches {@code a}, {@code a.b} and so on; {@code *}
 * matches everything (SCXML 1.0, section 3.12.1). There are infinitely many such events; used are those named anywhere
 * in the document, and {@code *} for any other.
 */
final class ScxmlEvents {
    private static final String DONE = "done.state.";
    private static final String ANY = "*";
    /** A time trigger such as {@code after 2 s} or {@code tm( 2 s )}, with any unit, or else a word. */
    private static final Pattern DESCRIPTOR = Pattern.compile("(?i:after|tm)\\s*\\([^)]*\\)(?=\\s|$)"
            + "|(?i:after)\\s+(?:(?i:PT?[0-9]\\S*)|[0-9.,]+(?:\\s*(?!(?i:after|tm)\\b)\\p{L}+)?)(?=\\s|$)"
            + "|\\S+");

    private final ScxmlTree tree;
    private final Problems problems;
    private final NavigableSet<String> named = new TreeSet<>();
    /** By the attribute as written. */
    private final Map<String, List<String>> descriptors = new HashMap<>();

    private final Map<String, Matched> matched = new HashMap<>();

    /**
     * What the descriptors of an attribute match.
     *
     * @param done states whose completion they match
     * @param triggers names of all other events
     * @param anyDone whether they match the completion of every state
     */
    record Matched(List<ScxmlVertex> done, List<String> triggers, boolean anyDone) {}

    ScxmlEvents(ScxmlTree tree, Problems problems) {
        this.tree = tree;
        this.problems = problems;
        tree.descriptors().forEach(attribute -> descriptors.put(attribute, split(attribute)));
        descriptors.values().forEach(this::name);
    }

    /** The descriptors without a suffix {@code .*} or {@code .}, which adds nothing. */
    private static List<String> split(String attribute) {
        List<String> names = new ArrayList<>();
        for (String descriptor : descriptors(attribute)) {
            String name = descriptor;
            if (descriptor.indexOf(' ') >= 0 || descriptor.indexOf('(') >= 0) {
                // A time trigger is not a prefix.
                names.add(descriptor);
                continue;
            }
            while (name.endsWith(".*") || name.endsWith(".")) {
                name = name.substring(0, name.lastIndexOf('.'));
            }
            names.add(name.equals(ANY) ? "" : name);
        }
        return names;
    }

    /** The descriptors, separated by white space; a time trigger may contain white space. */
    static List<String> descriptors(String attribute) {
        Matcher descriptor = DESCRIPTOR.matcher(attribute.strip());
        List<String> found = new ArrayList<>(1);
        while (descriptor.find()) {
            found.add(descriptor.group().replaceAll("\\s+", " "));
        }
        return found;
    }

    private void name(List<String> names) {
        for (String name : names) {
            if (doneState(name) == null) {
                named.add(name.isEmpty() ? ANY : name);
            }
        }
    }

    private @Nullable ScxmlVertex doneState(String descriptor) {
        ScxmlVertex state = descriptor.startsWith(DONE) ? tree.find(descriptor.substring(DONE.length())) : null;
        return state != null && state.canBeDone() ? state : null;
    }

    /**
     * The events that trigger a transition.
     *
     * @param attribute its descriptors as written
     */
    Matched matched(String attribute) {
        Matched known = matched.get(attribute);
        if (known == null) {
            known = match(attribute);
            matched.put(attribute, known);
        }
        return known;
    }

    private Matched match(String attribute) {
        List<ScxmlVertex> done = new ArrayList<>();
        Set<String> triggers = new LinkedHashSet<>();
        boolean anyDone = false;
        for (String descriptor : descriptors.getOrDefault(attribute, List.of())) {
            ScxmlVertex state = doneState(descriptor);
            if (state != null) {
                done.add(state);
            } else if (descriptor.isEmpty()) {
                triggers.addAll(named);
                anyDone = true;
            } else {
                if (named.contains(descriptor)) {
                    triggers.add(descriptor);
                }
                // Everything that begins with the descriptor and a dot; the slash is the character after the dot.
                triggers.addAll(named.subSet(descriptor + '.', descriptor + '/'));
                anyDone |= DONE.startsWith(descriptor + '.');
            }
        }
        return new Matched(List.copyOf(done), List.copyOf(triggers), anyDone);
    }

    /**
     * Refuses descriptors that match the completion of every state, if one can complete while the transition's state is
     * active.
     */
    void requireNamed(Matched matched, XmlNode transition, ScxmlVertex state, Supplier<String> label) {
        if (matched.anyDone() && tree.mayHearOfDone(state)) {
            problems.add(
                    transition.line(),
                    label.get() + " matches the events of all states that can be done, which is not supported; "
                            + "name the events");
        }
    }

    /** The transitions that take this event, at any depth. */
    static List<XmlNode> takers(List<XmlNode> children, String event) {
        List<XmlNode> takers = new ArrayList<>();
        for (XmlNode child : children) {
            if (child.name().equals("transition")) {
                if (takes(child, event)) {
                    takers.add(child);
                }
            } else {
                takers.addAll(takers(child.children(), event));
            }
        }
        return takers;
    }

    /** Whether a transition takes this event, if its condition holds. */
    static boolean takes(XmlNode transition, String event) {
        return names(transition, event)
                || descriptors(transition.attribute("event")).contains(ANY);
    }

    /** Whether a transition takes this event, and not just any. */
    static boolean names(XmlNode transition, String event) {
        return descriptors(transition.attribute("event")).stream().anyMatch(descriptor -> matches(descriptor, event));
    }

    /** Whether the descriptor is the event, or the words with which it begins. */
    static boolean matches(String descriptor, String event) {
        String name = descriptor.endsWith(".*") ? descriptor.substring(0, descriptor.length() - 2) : descriptor;
        return event.equals(name) || event.startsWith(name + ".");
    }
}
