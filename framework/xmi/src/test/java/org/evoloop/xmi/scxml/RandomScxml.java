package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;

/** Random documents with every construct that has a meaning for flattening, small enough to be read when a test fails. */
final class RandomScxml {
    static final List<String> EVENTS = List.of("a", "b", "b.c", "d");
    static final List<String> GUARDS = List.of("g", "h");

    /**
     * What is drawn, in percent where it is a chance.
     *
     * @param states about how many
     * @param parallel that a composite state is parallel
     * @param transitions at most, of each state
     * @param completion that a transition has no event, or waits for a state to be done
     */
    record Shape(int states, int parallel, int transitions, int guards, int completion) {}

    /** A state, with the text inside its element. */
    private record Drawn(String id, String kind, List<Drawn> inner, StringBuilder text) {}

    private final Random random;
    private final Shape shape;
    private final List<Drawn> all = new ArrayList<>();
    private final Map<String, Drawn> parents = new TreeMap<>();
    private final List<Drawn> histories = new ArrayList<>();
    private int keys;

    private RandomScxml(Random random, Shape shape) {
        this.random = random;
        this.shape = shape;
    }

    static String draw(Random random, Shape shape) {
        return new RandomScxml(random, shape).draw();
    }

    private String draw() {
        Drawn root = new Drawn("", "scxml", new ArrayList<>(), new StringBuilder());
        fill(root, 0);
        all.forEach(this::complete);
        return "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' name='random'" + initial(root) + ">"
                + content(root) + "</scxml>";
    }

    private void fill(Drawn state, int depth) {
        for (int i = 1 + random.nextInt(3); i > 0; i--) {
            boolean end = !state.kind().equals("parallel") && !state.inner().isEmpty() && chance(20);
            boolean composite = !end && depth < 3 && all.size() < shape.states() && chance(50);
            String kind = end ? "final" : composite && chance(shape.parallel()) ? "parallel" : "state";
            Drawn inner = new Drawn("s" + ++keys, kind, new ArrayList<>(), new StringBuilder());
            all.add(inner);
            parents.put(inner.id(), state);
            state.inner().add(inner);
            if (composite) {
                fill(inner, depth + 1);
            }
        }
        if (depth > 0 && chance(20)) {
            Drawn history = new Drawn("h" + ++keys, "history", new ArrayList<>(), new StringBuilder());
            parents.put(history.id(), state);
            histories.add(history);
        }
    }

    private void complete(Drawn state) {
        block(state, "onentry", 60);
        block(state, "onexit", 60);
        if (state.kind().equals("final")) {
            return;
        }
        for (int i = random.nextInt(shape.transitions() + 1); i > 0; i--) {
            transition(state);
        }
        histories.stream()
                .filter(history -> parents.get(history.id()) == state)
                .forEach(history -> state.text()
                        .append("<history id='" + history.id() + "' type='" + (chance(50) ? "deep" : "shallow") + "'>"
                                + "<transition target='" + inside(state) + "'>" + script("default", 50)
                                + "</transition></history>"));
        if (state.kind().equals("state") && !state.inner().isEmpty() && chance(20)) {
            state.text()
                    .append("<initial><transition target='" + inside(state) + "'>" + script("initial", 60)
                            + "</transition></initial>");
        }
    }

    private void transition(Drawn state) {
        // Without an event it leads on, so that most of these come to an end.
        List<String> later = all.subList(all.indexOf(state) + 1, all.size()).stream()
                .filter(other -> !isInside(other, state))
                .map(Drawn::id)
                .toList();
        String event = event(state, !later.isEmpty());
        String target = event.isEmpty() ? later.get(random.nextInt(later.size())) : chance(12) ? "" : target();
        state.text()
                .append("<transition")
                .append(event.isEmpty() ? "" : " event='" + event + "'")
                .append(chance(shape.guards()) && !event.isEmpty() ? " cond='" + one(GUARDS) + "'" : "")
                .append(target.isEmpty() ? "" : " target='" + target + "'")
                .append(chance(20) ? " type='internal'" : "")
                .append(">" + script("effect", 60) + "</transition>");
    }

    private boolean isInside(Drawn inner, Drawn outer) {
        Drawn around = parents.get(inner.id());
        return around == outer || (around != null && isInside(around, outer));
    }

    private String event(Drawn state, boolean mayBeLeft) {
        if (chance(shape.completion())) {
            return mayBeLeft && chance(25) ? "" : "done.state." + one(all).id();
        }
        if (chance(6)) {
            return "tm(" + state.id().substring(1) + "s)";
        }
        return chance(5) ? "*" : chance(10) ? one(EVENTS) + " " + one(EVENTS) : one(EVENTS);
    }

    private String target() {
        if (!histories.isEmpty() && chance(25)) {
            return one(histories).id();
        }
        List<Drawn> parallels = parallels();
        return !parallels.isEmpty() && chance(20) ? split(one(parallels)) : one(all).id();
    }

    /** A state in each of two children of a parallel state. */
    private String split(Drawn parallel) {
        int first = random.nextInt(parallel.inner().size() - 1);
        return within(parallel.inner().get(first)) + " "
                + within(parallel.inner().get(first + 1));
    }

    private String within(Drawn state) {
        return state.inner().isEmpty() || chance(30) ? state.id() : within(one(state.inner()));
    }

    /** One state inside this one, or several in different children of a parallel state. */
    private String inside(Drawn state) {
        List<Drawn> parallels = parallels().stream()
                .filter(parallel -> parallel == state || isInside(parallel, state))
                .toList();
        return !parallels.isEmpty() && chance(40) ? split(one(parallels)) : within(one(state.inner()));
    }

    private List<Drawn> parallels() {
        return all.stream()
                .filter(state ->
                        state.kind().equals("parallel") && state.inner().size() > 1)
                .toList();
    }

    private String initial(Drawn state) {
        return chance(50) && !state.text().toString().contains("<initial>") ? " initial='" + inside(state) + "'" : "";
    }

    private String content(Drawn state) {
        StringBuilder text = new StringBuilder(state.text());
        for (Drawn inner : state.inner()) {
            boolean starts = inner.kind().equals("state") && !inner.inner().isEmpty();
            text.append("\n<" + inner.kind() + " id='" + inner.id() + "'" + (starts ? initial(inner) : "") + ">")
                    .append(content(inner))
                    .append("</" + inner.kind() + ">");
        }
        return text.toString();
    }

    private void block(Drawn state, String name, int percent) {
        String script = script(name, percent);
        state.text().append(script.isEmpty() ? "" : "<" + name + ">" + script + "</" + name + ">");
    }

    private String script(String word, int percent) {
        return chance(percent) ? "<script>" + word + " " + ++keys + "</script>" : "";
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private <T> T one(List<T> some) {
        return some.get(random.nextInt(some.size()));
    }
}
