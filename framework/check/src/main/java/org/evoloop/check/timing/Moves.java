package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.check.timing.Situation.Branch;
import org.evoloop.engine.Rules;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** The possible moves in a row of clocks, and whether time can pass first. */
final class Moves {
    private final Rules rules;
    private final Clocks clocks;
    private final Situations situations;
    private final Surroundings around;
    private final Rows rows;
    private final List<TimeForm> forms;
    private final List<Set<Event>> raised;
    private final List<Edge> edges = new ArrayList<>();

    /** What is known of each situation, by its number: what may be asked for in it is looked up most. */
    private final List<Known> known = new ArrayList<>();

    private final List<Stimulus> presses;

    private record Known(Map<Stimulus, List<Edge>> edges, List<List<Move>> presses, List<Stimulus> acts) {}

    /**
     * Something that can happen.
     *
     * @param coming which of the awaited events it is; -1 if none
     * @param owed the monitor from whose violation it follows; -1 if none
     */
    record Move(Edge edge, int coming, int owed) {}

    /** @param raised for each monitor what follows from its violation */
    Moves(
            Rules rules,
            Clocks clocks,
            Situations situations,
            Surroundings around,
            Rows rows,
            List<TimeForm> forms,
            List<Set<Event>> raised) {
        this.rules = rules;
        this.clocks = clocks;
        this.situations = situations;
        this.around = around;
        this.rows = rows;
        this.forms = forms;
        this.raised = raised;
        this.presses = around.presses().stream()
                .map(event -> Stimulus.of(Stimulus.Kind.PRESS, event))
                .toList();
    }

    Edge edge(int number) {
        return edges.get(number);
    }

    /** The ways in which it begins. */
    List<Edge> opening() {
        return edges(null, situations.opening());
    }

    private List<Edge> edges(@Nullable Stimulus stimulus, List<Branch> branches) {
        List<Edge> made = new ArrayList<>();
        for (Branch branch : branches) {
            Edge edge = new Edge(
                    edges.size(),
                    stimulus,
                    branch,
                    forms,
                    clocks.comings,
                    rules.table().models());
            edges.add(edge);
            made.add(edge);
        }
        return made;
    }

    private Known known(Situation situation) {
        while (known.size() <= situation.number) {
            Situation next = situations.number(known.size());
            known.add(new Known(new HashMap<>(), new ArrayList<>(), around.acts(next)));
        }
        return known.get(situation.number);
    }

    private void add(Situation situation, Stimulus stimulus, int coming, int owed, List<Move> moves) {
        Known here = known(situation);
        List<Edge> all = here.edges().get(stimulus);
        if (all == null) {
            all = edges(stimulus, situations.after(situation, stimulus));
            here.edges().put(stimulus, all);
        }
        if (situations.size() > Exploration.MOST_SITUATIONS) {
            throw new TooLargeException("there are more than " + Exploration.MOST_SITUATIONS
                    + " situations that differ in more than time, such as in what waits in the queue");
        }
        all.forEach(edge -> moves.add(new Move(edge, coming, owed)));
    }

    /** What has to happen before time can pass, or may happen at any time. */
    List<Move> unasked(int[] row) {
        Situation situation = situations.number(row[Clocks.SITUATION]);
        List<Move> moves = new ArrayList<>();
        for (int owed = 0; owed < clocks.monitors.size(); owed++) {
            if (row[clocks.owedAt + owed] != 0) {
                for (Event event : raised.get(owed)) {
                    add(situation, Stimulus.of(Stimulus.Kind.REACT, event), -1, owed, moves);
                }
            }
        }
        if (!situation.isLeaving()) {
            for (int timer = 0; timer < situation.timers.size(); timer++) {
                if (!situation.heard[timer] && row[Clocks.TIMERS + timer] == 0) {
                    add(situation, Stimulus.timer(situation.timers.get(timer), timer), -1, -1, moves);
                }
            }
        }
        Span step = span(situation.sending());
        if (situation.sending() != null && row[Clocks.STEP] >= clocks.ticks.of(step.minNanos())) {
            add(situation, Stimulus.LANDING, -1, -1, moves);
        }
        for (int coming = 0; coming < clocks.comings.size(); coming++) {
            if (isAwaited(coming, row, situation) && age(coming, row) >= clocks.min(clocks.comings.get(coming))) {
                for (Stimulus stimulus : around.arrivals(coming, situation)) {
                    if (rows.mayCome(stimulus, row)) {
                        add(situation, stimulus, coming, -1, moves);
                    }
                }
            }
        }
        return moves;
    }

    /** The events that may be requested, and what the device may do, at this moment or never. */
    List<Move> asked(int[] row) {
        Situation situation = situations.number(row[Clocks.SITUATION]);
        Known here = known(situation);
        List<Move> moves = new ArrayList<>();
        for (Stimulus act : here.acts()) {
            if (rows.mayCome(act, row)) {
                add(situation, act, -1, -1, moves);
            }
        }
        for (int press = 0; press < presses.size(); press++) {
            if (press == here.presses().size()) {
                List<Move> ways = new ArrayList<>();
                add(situation, presses.get(press), -1, -1, ways);
                here.presses().add(ways);
            }
            if (rows.mayCome(presses.get(press), row)) {
                moves.addAll(here.presses().get(press));
            }
        }
        return moves;
    }

    private int age(int coming, int[] row) {
        return row[clocks.comingsAt + coming] - 1;
    }

    private boolean isAwaited(int coming, int[] row, Situation situation) {
        Assumption.Comes comes = clocks.comings.get(coming);
        int age = age(coming, row);
        return age >= 0 && age <= clocks.max(comes) && !Surroundings.isTimed(comes, situation);
    }

    private Span span(@Nullable Step step) {
        Span none = new Span(0, 0);
        return step == null ? none : clocks.takes.getOrDefault(step.trigger().name(), none);
    }

    /** Whether something has to happen before time can pass. */
    boolean isBlocked(int[] row) {
        Situation situation = situations.number(row[Clocks.SITUATION]);
        for (int owed = 0; owed < clocks.monitors.size(); owed++) {
            if (row[clocks.owedAt + owed] != 0) {
                return true;
            }
        }
        if (due(row) > 0 && !situation.isLeaving()) {
            return true;
        }
        boolean overdue = situation.sending() != null
                && row[Clocks.STEP] >= clocks.ticks.of(span(situation.sending()).maxNanos());
        for (int coming = 0; coming < clocks.comings.size(); coming++) {
            overdue |= isAwaited(coming, row, situation) && age(coming, row) == clocks.max(clocks.comings.get(coming));
        }
        return overdue;
    }

    /** How many timers are due and have not raised their events yet. */
    int due(int[] row) {
        Situation situation = situations.number(row[Clocks.SITUATION]);
        int due = 0;
        for (int timer = 0; timer < situation.timers.size(); timer++) {
            due += !situation.heard[timer] && row[Clocks.TIMERS + timer] == 0 ? 1 : 0;
        }
        return due;
    }
}
