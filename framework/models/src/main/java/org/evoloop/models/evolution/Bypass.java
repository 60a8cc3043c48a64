package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The effect of a bypass: while the converter is down, the controller's events are passed on to the device unchanged.
 *
 * <p>Threading: immutable.
 *
 * @param stopped the pairs of states in which a function, or a timer, of the new model would run
 */
public record Bypass(ModelPair pair, List<Line> lines, List<Configuration> stopped) {
    public Bypass {
        lines = List.copyOf(lines);
        stopped = List.copyOf(stopped);
    }

    /** The effect of an event that is passed on. */
    public enum Kind {
        /** The same as with the converter. */
        SAME,
        /** The device does something else than with the converter. */
        OTHER,
        /** The device ignores it in this state. */
        IGNORED,
        /** The device has no such event. */
        UNKNOWN
    }

    /**
     * One event in one pair of states.
     *
     * @param device the device's state after it
     * @param decision what the converter would have decided
     * @param found both models' states after the converter is back and has located the device
     */
    public record Line(
            Configuration at, Event event, Kind kind, State device, Decision decision, Configuration found) {}

    /**
     * Analyses each event of a controller in each reachable pair of states.
     *
     * @param pair a valid one
     */
    public static Bypass of(ModelPair pair, DeviceEvents events) {
        DecisionTable table = DecisionTable.compile(pair, events);
        List<Line> lines = new ArrayList<>();
        List<Configuration> stopped = new ArrayList<>();
        for (Configuration at : table.configurations()) {
            for (Event event : asked(at, table)) {
                lines.add(line(at, event, table));
            }
            if (pair.isNew(at.evolved()) || !pair.evolved().timers(at.evolved()).isEmpty()) {
                stopped.add(at);
            }
        }
        return new Bypass(pair, lines, stopped);
    }

    /** The events that a controller may send there: no time events, and none that only the device itself can raise. */
    private static Set<Event> asked(Configuration at, DecisionTable table) {
        ModelPair pair = table.models();
        Set<Event> asked = new LinkedHashSet<>();
        Stream.concat(
                        pair.evolved().transitionsFrom(at.evolved()).stream(),
                        pair.original().transitionsFrom(at.original()).stream())
                .map(Transition::event)
                .filter(event -> event.timeTrigger().isEmpty() && !table.isDevicesOwn(event.trigger()))
                .forEach(asked::add);
        return asked;
    }

    private static Line line(Configuration at, Event event, DecisionTable table) {
        Decision decision = table.decide(at, event, false);
        Step step = table.ownStep(at.original(), event.trigger(), event.guards()::contains);
        State device = step == null ? at.original() : step.target();
        return new Line(
                at,
                event,
                kind(event, step, decision, table.models()),
                device,
                decision,
                table.find(at, device).after());
    }

    private static Kind kind(Event event, @Nullable Step step, Decision decision, ModelPair pair) {
        if (step == null) {
            return pair.original().triggers().contains(event.trigger()) ? Kind.IGNORED : Kind.UNKNOWN;
        }
        List<Step> sent = decision.steps();
        boolean same = !(decision instanceof Decision.Impossible)
                && sent.size() == 1
                && sent.get(0).transition().equals(step.transition());
        return same ? Kind.SAME : Kind.OTHER;
    }
}
