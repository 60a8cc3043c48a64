package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.check.TimedEvent;
import org.evoloop.check.timing.Moves.Move;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * Finds timing errors that need no property: two timers due at the same instant, a step that is being sent when a timer
 * of its own visit is due, and time that cannot advance.
 */
final class TimeHazards implements Exploration.Judge {
    private final Exploration exploration;
    private final List<Integer> blocked = new ArrayList<>();
    private final Map<String, Finding> found = new TreeMap<>();

    TimeHazards(Exploration exploration) {
        this.exploration = exploration;
    }

    @Override
    public boolean goes(int from, int label, Rows rows) {
        return false;
    }

    @Override
    public void looks(int number, int[] row, boolean isBlocked) {
        if (isBlocked) {
            blocked.add(number);
        }
        int due = exploration.moves.due(row);
        Situation situation = exploration.situations.number(row[Clocks.SITUATION]);
        if (due > 1 && !situation.isLeaving()) {
            race(number, row, situation);
        }
        if (due > 0 && situation.sending() != null) {
            outlive(number, row, situation);
        }
    }

    private void race(int number, int[] row, Situation situation) {
        State state = situation.at().evolved();
        String timers = String.join(
                " and ", due(row, situation).stream().map(Event::toString).toList());
        add(
                number,
                Rule.TIMER_RACE,
                state,
                timers + " can be due in the same instant in " + state + ", and which comes first is not certain",
                "give one of them another time, or draw one transition for both");
    }

    private void outlive(int number, int[] row, Situation situation) {
        Step step = situation.sending();
        for (int timer = 0; timer < situation.timers.size(); timer++) {
            boolean isDue = !situation.heard[timer] && row[Clocks.TIMERS + timer] == 0;
            if (step != null && isDue && situation.outlasts(timer)) {
                State state = situation.at().evolved();
                add(
                        number,
                        Rule.STEP_OUTLIVES_VISIT,
                        state,
                        step.trigger() + " can still be on its way to the device when " + situation.timers.get(timer)
                                + " is due in " + state + ", which has to wait for it",
                        "let the timer run longer than the device takes, or have the step sent in a state of its own");
            }
        }
    }

    private static List<Event> due(int[] row, Situation situation) {
        List<Event> due = new ArrayList<>();
        for (int timer = 0; timer < situation.timers.size(); timer++) {
            if (!situation.heard[timer] && row[Clocks.TIMERS + timer] == 0) {
                due.add(situation.timers.get(timer));
            }
        }
        return due;
    }

    private void add(int number, Rule rule, State state, String message, String remedy) {
        String key = rule.id() + " " + message;
        if (!found.containsKey(key)) {
            List<TimedEvent> way = Trace.of(exploration, number, Exploration.TICK, rule.id());
            Element element = new Element.OfState(Element.ModelRole.NEW, state);
            found.put(key, new Finding(rule, element, message, remedy, List.of(), way));
        }
    }

    /** What was found, with the first moment from which nothing leads on in time. */
    List<Finding> findings() {
        BitSet stuck = new BitSet();
        blocked.forEach(stuck::set);
        int[] row = new int[exploration.clocks.length];
        int[] next = new int[exploration.clocks.length];
        for (boolean changed = true; changed; ) {
            changed = false;
            for (int index = blocked.size() - 1; index >= 0; index--) {
                int number = blocked.get(index);
                if (stuck.get(number) && continues(number, stuck, row, next)) {
                    stuck.clear(number);
                    changed = true;
                }
            }
        }
        blocked.stream().filter(stuck::get).findFirst().ifPresent(this::halt);
        return List.copyOf(found.values());
    }

    private boolean continues(int number, BitSet stuck, int[] row, int[] next) {
        exploration.visited.get(number, exploration.clocks.packing, row);
        for (Move move : exploration.moves.unasked(row)) {
            exploration.rows.happen(row, move.edge(), move.coming(), move.owed(), next);
            if (!stuck.get(exploration.number(next))) {
                return true;
            }
        }
        return false;
    }

    private void halt(int number) {
        int[] row = new int[exploration.clocks.length];
        exploration.visited.get(number, exploration.clocks.packing, row);
        State state = exploration.situations.number(row[Clocks.SITUATION]).at().evolved();
        add(
                number,
                Rule.TIME_DEADLOCK,
                state,
                "time comes to a halt in " + state
                        + ": something has to happen before any time can pass, and all that can happen leads back "
                        + "there",
                "let timers that follow each other in a circle take time, and check the assumptions about when events "
                        + "come");
    }
}
