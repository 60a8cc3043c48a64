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
 * Which events a transition's descriptors match. {@code a} matches {@code a}, {@code a.b} and so on, {@code *}
 * everything (SCXML 1.0, section 3.12.1); of the endlessly many, these are the events that the document names anywhere,
 * and {@code *} for one that it does not name.
 */
final class ScxmlEvents {
    private static final String DONE = "done.state.";
    private static final String ANY = "*";
    /** A time trigger such as {@code after 2 s} or {@code tm( 2 s )}, or else a word. */
    private static final Pattern DESCRIPTOR = Pattern.compile("(?i:after|tm)\\s*\\([^)]*\\)(?=\\s|$)"
            + "|(?i:after)\\s+(?:(?i:PT?[0-9]\\S*)|[0-9.]+(?:\\s*(?i:ms|msec|milliseconds?|s|sec|seconds?|min"
            + "|minutes?|h|hours?|d|days?))?)(?=\\s|$)"
            + "|\\S+");

    private final ScxmlTree tree;
    private final Problems problems;
    private final NavigableSet<String> named = new TreeSet<>();
    /** By the attribute as written, of which there are far fewer than transitions. */
    private final Map<String, List<String>> descriptors = new HashMap<>();

    private final Map<String, Matched> matched = new HashMap<>();

    /**
     * What the descriptors of an attribute match.
     *
     * @param done states whose being done they match
     * @param triggers names of all other events
     * @param anyDone whether they match the events of all states that can be done
     */
    record Matched(List<ScxmlVertex> done, List<String> triggers, boolean anyDone) {}

    ScxmlEvents(ScxmlTree tree, Problems problems) {
        this.tree = tree;
        this.problems = problems;
        tree.document().children().forEach(this::collect);
        descriptors.values().forEach(this::name);
    }

    private void collect(XmlNode node) {
        switch (node.name()) {
            case "transition", "send", "raise" ->
                descriptors.computeIfAbsent(node.attribute("event"), ScxmlEvents::split);
            default -> {}
        }
        // Most hold none, and an iterator for each would be thrown away.
        if (!node.children().isEmpty()) {
            node.children().forEach(this::collect);
        }
    }

    /** Each without what says no more than that it is a prefix. */
    private static List<String> split(String attribute) {
        List<String> names = new ArrayList<>();
        for (String descriptor : descriptors(attribute)) {
            String name = descriptor;
            if (descriptor.indexOf(' ') >= 0 || descriptor.indexOf('(') >= 0) {
                // A time trigger is no prefix.
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

    /** Between white space, but for that in a time trigger. */
    private static List<String> descriptors(String attribute) {
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

    /** What triggers a transition. */
    Matched matched(XmlNode transition) {
        String attribute = transition.attribute("event");
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
                // Whatever begins with the descriptor and a dot; in the order of characters a slash comes next.
                triggers.addAll(named.subSet(descriptor + '.', descriptor + '/'));
                anyDone |= DONE.startsWith(descriptor + '.');
            }
        }
        return new Matched(List.copyOf(done), List.copyOf(triggers), anyDone);
    }

    /** Refuses descriptors that match the end of any state, if one can end while the transition's state is active. */
    void requireNamed(Matched matched, XmlNode transition, ScxmlVertex state, Supplier<String> label) {
        if (matched.anyDone() && tree.mayHearOfDone(state)) {
            problems.add(
                    transition.line(),
                    label.get() + " matches the events of all states that can be done, which is not supported; "
                            + "name the events");
        }
    }
}
