package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * Finds the events that a transition's descriptors match. {@code a} matches {@code a}, {@code a.b} and so on; {@code *}
 * matches everything (SCXML 1.0, section 3.12.1). There are infinitely many such events; used are those named anywhere
 * in the document, and {@code *} for any other. A time trigger is matched only by
 * itself: it belongs to the state that names it.
 */
final class ScxmlEvents {
    private static final String DONE = "done.state.";
    private static final String ANY = "*";
    /** A time trigger such as {@code after 2 s} or {@code tm( 2 s )}, with any unit, or else a word. */
    private static final Pattern DESCRIPTOR = Pattern.compile("(?i:after|tm)\\s*\\([^)]*\\)(?=\\s|$)"
            + "|(?i:after)\\s+(?:(?i:PT?[0-9]\\S*)|[0-9.,]+(?:\\s*(?!(?i:after|tm)\\b)\\p{L}+)?)(?=\\s|$)"
            + "|\\S+");

    private final ScxmlTree tree;
    private final NavigableSet<String> named = new TreeSet<>();
    /** By the attribute as written. */
    private final Map<String, List<String>> descriptors = new HashMap<>();

    private final Map<String, List<String>> matched = new HashMap<>();

    ScxmlEvents(ScxmlTree tree) {
        this.tree = tree;
        tree.descriptors().forEach(attribute -> descriptors.put(attribute, split(attribute)));
        descriptors
                .values()
                .forEach(names -> names.stream()
                        .filter(name -> doneState(name) == null)
                        .forEach(name -> named.add(name.isEmpty() ? ANY : name)));
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

    /** The state that the event would tell is done; null for all other events. */
    private @Nullable ScxmlVertex doneState(String event) {
        return event.startsWith(DONE) ? tree.find(event.substring(DONE.length())) : null;
    }

    /** The states for whose end these descriptors wait in vain. */
    List<ScxmlVertex> neverDone(String attribute) {
        return descriptors.getOrDefault(attribute, List.of()).stream()
                .map(this::doneState)
                .filter(state -> state != null && !state.canBeDone())
                .map(Objects::requireNonNull)
                .toList();
    }

    /** The ids in these descriptors that tell that a state is done, but are those of no state. */
    List<String> unknownDone(String attribute) {
        return descriptors.getOrDefault(attribute, List.of()).stream()
                .filter(event -> event.startsWith(DONE) && doneState(event) == null)
                .map(event -> event.substring(DONE.length()))
                .toList();
    }

    /**
     * The events that trigger a transition. Those that tell that a state is done are matched while the machine runs.
     *
     * @param attribute its descriptors as written
     */
    List<String> matched(String attribute) {
        List<String> known = matched.get(attribute);
        if (known == null) {
            known = match(attribute);
            matched.put(attribute, known);
        }
        return known;
    }

    private List<String> match(String attribute) {
        Set<String> triggers = new LinkedHashSet<>();
        for (String descriptor : descriptors.getOrDefault(attribute, List.of())) {
            triggers.add(descriptor.isEmpty() ? ANY : descriptor);
            // Everything that begins with the descriptor and a dot; the slash is the character after the dot.
            Set<String> more = descriptor.isEmpty() ? named : named.subSet(descriptor + '.', descriptor + '/');
            more.stream().filter(name -> !isTime(name)).forEach(triggers::add);
        }
        return List.copyOf(triggers);
    }

    /** Whether it is a time trigger, or looks like one. */
    static boolean isTime(String name) {
        try {
            return new Event(name).timeTrigger().isPresent();
        } catch (ModelException malformed) {
            // A time trigger without a unit, which may be given for the whole file.
            return true;
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
