package org.evoloop.xmi.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.Condition;
import org.evoloop.xmi.dialect.Problems;
import org.jspecify.annotations.Nullable;

/**
 * What the lines of a diagram have said so far: its states, their regions, and the transitions.
 *
 * <p>Threading: for one thread.
 */
final class TextTree {
    static final int MAX_DEPTH = 300;
    private static final int MAX_ELEMENTS = 500_000;

    private static final Pattern KEYWORD = Pattern.compile("^(?:«[^»]*+»|<<[^>]*+>>)\\s*+");
    private static final Pattern TIME = Pattern.compile("(?i)(?:after|at|every|when)\\b");

    private final String file;
    private final Syntax syntax;
    private final Problems problems;
    private final Map<String, TextState> states = new LinkedHashMap<>();
    private final List<Scope> tops = new ArrayList<>();
    private final List<Arc> arcs = new ArrayList<>();
    private final List<Pseudostate> junctions = new ArrayList<>();
    /** The regions that are open, from the innermost to the diagram's own. */
    private final Deque<Scope> open = new ArrayDeque<>();

    private final Deque<Integer> openedAt = new ArrayDeque<>();
    private final Map<Scope, List<TextState>> contents = new HashMap<>();
    /** Those that are named outside of their regions. */
    private final List<History> histories = new ArrayList<>();

    private record History(TextState state, boolean deep, int line, int column) {}

    /** @param line of its first one */
    TextTree(String file, Syntax syntax, int line, Problems problems) {
        this.file = file;
        this.syntax = syntax;
        this.problems = problems;
        tops.add(new Scope(null, 1, line));
        open.push(tops.get(0));
    }

    /** The region in which the current line is. */
    Scope scope() {
        return open.element();
    }

    /** The state with this id, which this line names in the current region. */
    TextState state(String id, int line, int column, TextState.Naming naming) {
        TextState state = states.get(id);
        if (state == null) {
            state = new TextState(id, line);
            states.put(id, state);
            requireRoom(line);
        }
        state.mention(scope(), line, column, naming, syntax);
        return state;
    }

    /** The state with this id; null if no line names it. */
    @Nullable
    TextState known(String id) {
        return states.get(id);
    }

    /** All states, by their ids. */
    Map<String, TextState> states() {
        return states;
    }

    /** The diagram's own first region. */
    Scope top() {
        return tops.get(0);
    }

    private void requireRoom(int line) {
        if (states.size() + arcs.size() > MAX_ELEMENTS) {
            throw new ModelException(file + ": has more than " + MAX_ELEMENTS + " states and transitions (line " + line
                    + "): split the diagram");
        }
    }

    /** Enters the state's first region. */
    void open(TextState state, int line, int column) {
        if (open.size() > MAX_DEPTH) {
            throw new ModelException(file + ": nests states deeper than " + MAX_DEPTH + " (line " + line
                    + "): draw a machine of fewer levels");
        }
        if (!state.regions.isEmpty()) {
            problems.add(
                    line,
                    "column " + column + ": state '" + state.id() + "' has its contents in line "
                            + state.regions.get(0).place().line() + " already; write them in one place");
        }
        state.regions.add(new Scope(state, state.regions.size() + 1, line));
        open.push(state.regions.get(state.regions.size() - 1));
        openedAt.push(column);
    }

    /** Leaves the state that is open; returns whether one is. */
    boolean close() {
        if (open.size() == 1) {
            return false;
        }
        open.pop();
        openedAt.pop();
        return true;
    }

    /** Begins the next region of the state that is open, or of the diagram. */
    void separate(int line) {
        TextState owner = open.pop().owner();
        List<Scope> siblings = owner == null ? tops : owner.regions;
        Scope next = new Scope(owner, siblings.size() + 1, line);
        siblings.add(next);
        open.push(next);
    }

    /** The key of the history of the state's region, which may come in a later line. */
    String history(TextState state, boolean deep, int line, int column) {
        histories.add(new History(state, deep, line, column));
        return Scope.history(deep, state.id(), 1);
    }

    private void draw(History history) {
        TextState state = history.state();
        if (state.regions.size() == 1) {
            state.regions.get(0).history(history.deep(), history.line());
            return;
        }
        problems.add(
                history.line(),
                "column " + history.column() + ": state '" + state.id() + "' has "
                        + (state.regions.isEmpty() ? "no region" : state.regions.size() + " regions")
                        + ", and a history belongs to one; write " + (history.deep() ? "[H*]" : "[H]")
                        + " in the region itself");
    }

    /** Adds a transition. Of several guards, each after the first has a junction before it. */
    void arc(String source, String target, Label label, int line) {
        Place place = new Place("", line);
        Arc.Kind kind = label.local() ? Arc.Kind.LOCAL : Arc.Kind.EXTERNAL;
        List<String> guards = label.guards().isEmpty() ? List.of("") : label.guards();
        String from = source;
        List<String> triggers = label.triggers();
        for (String guard : guards.subList(0, guards.size() - 1)) {
            Pseudostate junction = new Pseudostate("[] " + junctions.size(), "", place, Kind.JUNCTION);
            junctions.add(junction);
            arcs.add(new Arc(place, from, junction.key(), triggers, guard, List.of(), kind));
            from = junction.key();
            triggers = List.of();
        }
        arcs.add(new Arc(place, from, target, triggers, guards.get(guards.size() - 1), label.effects(), kind));
        requireRoom(line);
    }

    /** The chart, once all lines have been read. */
    Statechart chart(String title) {
        if (open.size() > 1) {
            problems.add(
                    scope().place().line(),
                    "column " + openedAt.element() + ": state '" + scope().label()
                            + "' is not closed; write } behind its contents");
        }
        histories.forEach(this::draw);
        for (TextState state : states.values()) {
            if (state.isInItself()) {
                problems.add(
                        state.place().line(),
                        "state '" + state.id() + "' is named inside itself, where " + syntax
                                + " draws it; write its transitions outside of it");
                return new Statechart(title, tops.get(0).place(), List.of(), List.of());
            }
        }
        for (TextState state : states.values()) {
            state.check(syntax, problems);
            Scope home = state.home();
            if (home != null) {
                contents.computeIfAbsent(home, any -> new ArrayList<>()).add(state);
            }
        }
        if (states.isEmpty() && problems.isEmpty()) {
            problems.add(tops.get(0).place().line(), "the diagram has no state; write [*] --> NAME");
        }
        List<Region> regions = regions(tops);
        if (!regions.isEmpty()) {
            // All in one region, since the order of a state's transitions is that of the lines.
            Region first = regions.get(0);
            List<Vertex> vertices = new ArrayList<>(first.vertices());
            vertices.addAll(junctions);
            List<Arc> all = arcs.stream().map(this::meant).toList();
            regions.set(0, new Region(first.name(), first.place(), vertices, all));
        }
        return new Statechart(title, tops.get(0).place(), regions, List.of());
    }

    /** A transition with its label as its source gives it a meaning. */
    private Arc meant(Arc arc) {
        if (arc.triggers().isEmpty()) {
            return arc;
        }
        String text = String.join(", ", arc.triggers());
        TextState source = states.get(arc.source());
        if (source != null && source.kind() == Kind.CHOICE && arc.guard().isEmpty()) {
            return unlabelled(arc, Condition.guard(text));
        }
        if (source == null ? arc.source().startsWith(Scope.INITIAL) : source.kind() == Kind.INITIAL) {
            problems.note(
                    arc.place(),
                    Problems.quote(text)
                            + " at the start describes it, since nothing is waited for there; write / EFFECT"
                            + " for what is done");
            return unlabelled(arc, arc.guard());
        }
        if (arc.triggers().size() > 1 && arc.triggers().stream().anyMatch(TextTree::isProse)) {
            problems.note(
                    arc.place(),
                    Problems.quote(text) + " names " + arc.triggers().size()
                            + " events; write \\, for a comma in the name of one");
        }
        return arc;
    }

    /** Whether the event is called by several words. */
    private static boolean isProse(String trigger) {
        String event = KEYWORD.matcher(trigger).replaceFirst("");
        return event.indexOf(' ') > 0 && !TIME.matcher(event).lookingAt();
    }

    private static Arc unlabelled(Arc arc, String guard) {
        return new Arc(arc.place(), arc.source(), arc.target(), List.of(), guard, arc.effects(), arc.kind());
    }

    private List<Region> regions(List<Scope> scopes) {
        List<Region> regions = new ArrayList<>();
        for (Scope scope : scopes) {
            List<Vertex> vertices = new ArrayList<>();
            for (TextState state : contents.getOrDefault(scope, List.of())) {
                if (!isPoint(state)) {
                    vertices.add(vertex(state));
                }
            }
            vertices.addAll(scope.pseudostates());
            if (!vertices.isEmpty()) {
                regions.add(new Region("", scope.place(), vertices, List.of()));
            }
        }
        return regions;
    }

    /** Whether it is on the border of the state whose region names it. */
    private static boolean isPoint(TextState state) {
        Scope home = state.home();
        return (state.kind() == Kind.ENTRY_POINT || state.kind() == Kind.EXIT_POINT)
                && home != null
                && home.owner() != null;
    }

    private Vertex vertex(TextState state) {
        Kind kind = state.kind();
        if (kind == null && !state.isEnd()) {
            return new ChartState(
                    state.id(),
                    state.marked(),
                    state.place(),
                    state.entry,
                    state.exit,
                    state.activities,
                    state.internal,
                    state.deferred,
                    regions(state.regions),
                    points(state));
        }
        if (state.hasContents()) {
            problems.add(
                    state.place(),
                    "'" + state.id() + "' is a "
                            + (kind == null ? "final state" : kind.name().toLowerCase(Locale.ROOT))
                            + ", in which nothing happens; write its contents into a state");
        }
        String name = state.name().equals(state.id()) ? "" : state.name();
        return kind == null
                ? new FinalState(state.id(), name, state.place())
                : new Pseudostate(state.id(), name, state.place(), kind);
    }

    private List<Pseudostate> points(TextState state) {
        return state.regions.stream()
                .flatMap(scope -> contents.getOrDefault(scope, List.of()).stream())
                .filter(TextTree::isPoint)
                .map(point -> new Pseudostate(point.id(), point.name(), point.place(), pointKind(point)))
                .toList();
    }

    private static Kind pointKind(TextState point) {
        return point.kind() == Kind.EXIT_POINT ? Kind.EXIT_POINT : Kind.ENTRY_POINT;
    }
}
