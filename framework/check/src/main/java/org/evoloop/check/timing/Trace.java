package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.check.TimedEvent;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** The events up to a moment, with times. */
final class Trace {
    private final Exploration exploration;
    private final List<TimedEvent> events = new ArrayList<>();

    private Trace(Exploration exploration) {
        this.exploration = exploration;
    }

    /**
     * What leads to {@code number}, then what {@code label} says, and what is found there.
     *
     * @param number -1 for the beginning
     * @param label {@link Exploration#TICK} if nothing else happens
     */
    static List<TimedEvent> of(Exploration exploration, int number, int label, String found) {
        Trace trace = new Trace(exploration);
        int[] way = number < 0 ? new int[0] : exploration.way(number);
        for (int index = way.length - 1; index >= 0; index--) {
            Visited visited = exploration.visited;
            trace.add(visited.label(way[index]), visited.time(way[index]));
        }
        int time = number < 0 ? 0 : exploration.visited.time(number);
        trace.add(label, time);
        TimedEvent last = trace.events.get(trace.events.size() - 1);
        trace.events.add(new TimedEvent(exploration.clocks.ticks.nanos(time), found, last.after(), last.step()));
        return List.copyOf(trace.events);
    }

    private void add(int label, int time) {
        if (label != Exploration.TICK) {
            Edge edge = exploration.moves.edge(label);
            Situation target = edge.branch.target();
            Step step = target.sending();
            events.add(new TimedEvent(
                    exploration.clocks.ticks.nanos(time),
                    describe(edge.stimulus),
                    target.at(),
                    step == null ? "" : step.trigger().name()));
        }
    }

    private static String describe(@Nullable Stimulus stimulus) {
        if (stimulus == null) {
            return "start";
        }
        Event event = stimulus.event();
        if (event == null) {
            return "obeyed";
        }
        return switch (stimulus.kind()) {
            case ACT -> event + " (the device acted)";
            case REACT -> event + " (raised on a violation)";
            default -> event.toString();
        };
    }
}
