package org.evoloop.xmi.scxml;

import java.io.StringReader;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Element;
import org.xml.sax.InputSource;

/**
 * Runs a document by the algorithm of SCXML 1.0 (appendix D), function by function and with its names. Shares nothing
 * with the reader or with flattening. Each {@code script} is an action. A time trigger is matched only by its own name.
 */
final class ScxmlInterpreter {
    private static final Set<String> STATES = Set.of("state", "parallel", "final", "scxml");

    private final Element root;
    private final Map<String, Element> byId = new HashMap<>();
    /** Document order. */
    private final Map<Element, Integer> order = new HashMap<>();

    private final Set<Element> configuration = new HashSet<>();
    private final Map<Element, List<Element>> historyValue = new HashMap<>();
    private final Deque<String> internalQueue = new ArrayDeque<>();
    private boolean running = true;
    private List<String> actions = new ArrayList<>();
    private Predicate<String> guards = guard -> true;

    ScxmlInterpreter(String document) {
        try {
            root = DocumentBuilderFactory.newInstance()
                    .newDocumentBuilder()
                    .parse(new InputSource(new StringReader(document)))
                    .getDocumentElement();
        } catch (Exception malformed) {
            throw new IllegalArgumentException(document, malformed);
        }
        index(root);
    }

    private void index(Element element) {
        order.put(element, order.size());
        byId.put(element.getAttribute("id"), element);
        children(element).forEach(this::index);
    }

    List<String> start(Predicate<String> guardValues) {
        begin(guardValues);
        Element initial = root.getOwnerDocument().createElement("transition");
        initial.setAttribute("target", initial(root));
        enterStates(List.of(initial), root);
        macrostep();
        return actions;
    }

    /** The actions that an event ran; null if it enabled nothing. */
    @Nullable
    List<String> dispatch(String event, Predicate<String> guardValues) {
        begin(guardValues);
        List<Element> enabled = running ? selectTransitions(event) : List.of();
        if (enabled.isEmpty()) {
            return null;
        }
        microstep(enabled);
        macrostep();
        return actions;
    }

    private void begin(Predicate<String> guardValues) {
        actions = new ArrayList<>();
        guards = guardValues;
    }

    /** The ids of the active atomic states, in document order. */
    List<String> leaves() {
        return inOrder(configuration).stream()
                .filter(this::isAtomic)
                .map(state -> state.getAttribute("id"))
                .toList();
    }

    private void macrostep() {
        for (int round = 0; running; round++) {
            if (round > 1_000) {
                throw new IllegalStateException("endless");
            }
            List<Element> enabled = selectTransitions("");
            if (enabled.isEmpty()) {
                if (internalQueue.isEmpty()) {
                    return;
                }
                enabled = selectTransitions(internalQueue.remove());
            }
            microstep(enabled);
        }
        inReverse(configuration).forEach(state -> run(child(state, "onexit")));
    }

    private List<Element> selectTransitions(String event) {
        Set<Element> enabled = new LinkedHashSet<>();
        for (Element atomic :
                inOrder(configuration).stream().filter(this::isAtomic).toList()) {
            List<Element> chain = new ArrayList<>(List.of(atomic));
            chain.addAll(ancestors(atomic, null));
            search:
            for (Element state : chain) {
                for (Element transition : children(state, "transition")) {
                    if (matches(transition, event) && holds(transition)) {
                        enabled.add(transition);
                        break search;
                    }
                }
            }
        }
        return removeConflicting(enabled);
    }

    private static boolean matches(Element transition, String event) {
        String descriptors = transition.getAttribute("event");
        if (event.isEmpty() || descriptors.isEmpty()) {
            return event.isEmpty() && descriptors.isEmpty();
        }
        return Arrays.stream(descriptors.split(" "))
                .anyMatch(one -> one.equals(event)
                        || (!event.startsWith("tm(") && (one.equals("*") || event.startsWith(one + "."))));
    }

    private boolean holds(Element transition) {
        String guard = transition.getAttribute("cond");
        return guard.isEmpty() || guards.test(guard);
    }

    private List<Element> removeConflicting(Set<Element> enabled) {
        List<Element> filtered = new ArrayList<>();
        for (Element t1 : enabled) {
            boolean preempted = false;
            Set<Element> toRemove = new HashSet<>();
            for (Element t2 : filtered) {
                Set<Element> common = new HashSet<>(exitSet(t1));
                common.retainAll(exitSet(t2));
                if (!common.isEmpty()) {
                    if (isDescendant(source(t1), source(t2))) {
                        toRemove.add(t2);
                    } else {
                        preempted = true;
                        break;
                    }
                }
            }
            if (!preempted) {
                filtered.removeAll(toRemove);
                filtered.add(t1);
            }
        }
        return filtered;
    }

    private void microstep(List<Element> enabled) {
        Set<Element> exits = new HashSet<>();
        enabled.forEach(transition -> exits.addAll(exitSet(transition)));
        for (Element state : exits) {
            for (Element history : children(state, "history")) {
                boolean deep = history.getAttribute("type").equals("deep");
                historyValue.put(
                        history,
                        inOrder(configuration).stream()
                                .filter(active -> deep
                                        ? isAtomic(active) && isDescendant(active, state)
                                        : active.getParentNode() == state)
                                .toList());
            }
        }
        for (Element state : inReverse(exits)) {
            run(child(state, "onexit"));
            configuration.remove(state);
        }
        enabled.forEach(this::run);
        enterStates(enabled, null);
    }

    private Set<Element> exitSet(Element transition) {
        if (targets(transition).isEmpty()) {
            return Set.of();
        }
        Element domain = domain(transition);
        return configuration.stream()
                .filter(state -> isDescendant(state, domain))
                .collect(Collectors.toSet());
    }

    private void enterStates(List<Element> transitions, @Nullable Element wholeDomain) {
        Set<Element> toEnter = new HashSet<>();
        Set<Element> byDefault = new HashSet<>();
        Map<Element, Element> defaultHistoryContent = new HashMap<>();
        for (Element transition : transitions) {
            targets(transition).forEach(target -> addDescendants(target, toEnter, byDefault, defaultHistoryContent));
            if (!targets(transition).isEmpty()) {
                Element ancestor = wholeDomain == null ? domain(transition) : wholeDomain;
                effective(transition)
                        .forEach(state -> addAncestors(state, ancestor, toEnter, byDefault, defaultHistoryContent));
            }
        }
        for (Element state : inOrder(toEnter)) {
            configuration.add(state);
            run(child(state, "onentry"));
            Element initial = child(state, "initial");
            if (byDefault.contains(state) && initial != null) {
                run(child(initial, "transition"));
            }
            run(defaultHistoryContent.get(state));
            if (state.getTagName().equals("final")) {
                finish((Element) state.getParentNode());
            }
        }
    }

    private void finish(Element parent) {
        if (parent == root) {
            running = false;
            return;
        }
        internalQueue.add("done.state." + parent.getAttribute("id"));
        Element grandparent = (Element) parent.getParentNode();
        if (isParallel(grandparent) && states(grandparent).stream().allMatch(this::isInFinalState)) {
            internalQueue.add("done.state." + grandparent.getAttribute("id"));
        }
    }

    private boolean isInFinalState(Element state) {
        return isParallel(state)
                ? states(state).stream().allMatch(this::isInFinalState)
                : states(state).stream()
                        .anyMatch(child -> child.getTagName().equals("final") && configuration.contains(child));
    }

    private void addDescendants(
            Element state, Set<Element> toEnter, Set<Element> byDefault, Map<Element, Element> content) {
        Element parent = (Element) state.getParentNode();
        if (state.getTagName().equals("history")) {
            List<Element> value = historyValue.get(state);
            if (value == null) {
                Element transition = children(state, "transition").get(0);
                content.put(parent, transition);
                value = targets(transition);
            }
            value.forEach(one -> addDescendants(one, toEnter, byDefault, content));
            value.forEach(one -> addAncestors(one, parent, toEnter, byDefault, content));
            return;
        }
        toEnter.add(state);
        if (isParallel(state)) {
            addChildren(state, toEnter, byDefault, content);
        } else if (!isAtomic(state)) {
            byDefault.add(state);
            List<Element> initial = find(initial(state));
            initial.forEach(one -> addDescendants(one, toEnter, byDefault, content));
            initial.forEach(one -> addAncestors(one, state, toEnter, byDefault, content));
        }
    }

    private void addAncestors(
            Element state, Element until, Set<Element> toEnter, Set<Element> byDefault, Map<Element, Element> content) {
        for (Element ancestor : ancestors(state, until)) {
            toEnter.add(ancestor);
            if (isParallel(ancestor)) {
                addChildren(ancestor, toEnter, byDefault, content);
            }
        }
    }

    private void addChildren(
            Element parallel, Set<Element> toEnter, Set<Element> byDefault, Map<Element, Element> content) {
        for (Element child : states(parallel)) {
            if (toEnter.stream().noneMatch(state -> isDescendant(state, child))) {
                addDescendants(child, toEnter, byDefault, content);
            }
        }
    }

    private Element domain(Element transition) {
        List<Element> targets = effective(transition);
        Element source = source(transition);
        if (transition.getAttribute("type").equals("internal")
                && source.getTagName().equals("state")
                && !isAtomic(source)
                && targets.stream().allMatch(target -> isDescendant(target, source))) {
            return source;
        }
        return ancestors(source, null).stream()
                .filter(ancestor ->
                        !isParallel(ancestor) && targets.stream().allMatch(target -> isDescendant(target, ancestor)))
                .findFirst()
                .orElse(root);
    }

    private List<Element> effective(Element transition) {
        List<Element> effective = new ArrayList<>();
        for (Element target : targets(transition)) {
            if (!target.getTagName().equals("history")) {
                effective.add(target);
            } else if (historyValue.containsKey(target)) {
                effective.addAll(historyValue.get(target));
            } else {
                effective.addAll(effective(children(target, "transition").get(0)));
            }
        }
        return effective;
    }

    private List<Element> targets(Element transition) {
        return find(transition.getAttribute("target"));
    }

    private List<Element> find(String ids) {
        return Arrays.stream(ids.split(" "))
                .filter(id -> !id.isEmpty())
                .map(byId::get)
                .toList();
    }

    private String initial(Element state) {
        Element initial = child(state, "initial");
        if (initial != null) {
            return children(initial, "transition").get(0).getAttribute("target");
        }
        String ids = state.getAttribute("initial");
        return ids.isEmpty() ? states(state).get(0).getAttribute("id") : ids;
    }

    private static Element source(Element transition) {
        return (Element) transition.getParentNode();
    }

    private List<Element> ancestors(Element state, @Nullable Element until) {
        List<Element> ancestors = new ArrayList<>();
        for (Element outer = (Element) state.getParentNode();
                outer != root && outer != until;
                outer = (Element) outer.getParentNode()) {
            ancestors.add(outer);
        }
        return ancestors;
    }

    private boolean isDescendant(Element inner, Element outer) {
        return inner != outer && (outer == root || ancestors(inner, null).contains(outer));
    }

    private boolean isAtomic(Element state) {
        return states(state).isEmpty();
    }

    private static boolean isParallel(Element state) {
        return state.getTagName().equals("parallel");
    }

    private List<Element> inOrder(Set<Element> states) {
        return states.stream().sorted(Comparator.comparing(order::get)).toList();
    }

    private List<Element> inReverse(Set<Element> states) {
        return states.stream()
                .sorted(Comparator.comparing(order::get, Comparator.reverseOrder()))
                .toList();
    }

    private void run(@Nullable Element block) {
        if (block != null) {
            children(block, "script").forEach(script -> actions.add(script.getTextContent()));
        }
    }

    private static List<Element> states(Element state) {
        return children(state).stream()
                .filter(child -> STATES.contains(child.getTagName()))
                .toList();
    }

    private static @Nullable Element child(Element element, String name) {
        return children(element, name).stream().findFirst().orElse(null);
    }

    private static List<Element> children(Element element, String name) {
        return children(element).stream()
                .filter(child -> child.getTagName().equals(name))
                .toList();
    }

    private static List<Element> children(Element element) {
        return IntStream.range(0, element.getChildNodes().getLength())
                .mapToObj(element.getChildNodes()::item)
                .filter(Element.class::isInstance)
                .map(Element.class::cast)
                .toList();
    }
}
