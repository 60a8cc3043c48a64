package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.check.temporal.Formula;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;

/** What may happen around a converter in a situation, whenever time allows. */
final class Surroundings {
    private final DecisionTable table;
    private final List<Assumption.Comes> comings;
    private final Set<String> awaited;
    private final List<Event> presses;

    Surroundings(DecisionTable table, TimeRules written, List<Assumption.Comes> comings) {
        this.table = table;
        this.comings = comings;
        this.awaited = comings.stream().map(Assumption.Comes::event).collect(Collectors.toSet());
        Set<Event> controls = new LinkedHashSet<>(table.models().evolved().triggers());
        controls.removeIf(event ->
                event.timeTrigger().isPresent() || table.isDevicesOwn(event) || awaited.contains(event.name()));
        for (Reaction reaction : written.reactions()) {
            if (!table.models().original().triggers().contains(reaction.event())) {
                controls.remove(reaction.event());
            }
        }
        this.presses = List.copyOf(controls);
    }

    /** Events that somebody may ask for at any time: all that neither a timer, the device nor an assumption raises. */
    List<Event> presses() {
        return presses;
    }

    /** What the device may do by itself at any time. */
    List<Stimulus> acts(Situation situation) {
        List<Stimulus> acts = new ArrayList<>();
        for (Transition transition :
                table.models().original().transitionsFrom(situation.at().original())) {
            Event trigger = transition.event().trigger();
            boolean any = table.device().spontaneous().contains(trigger)
                    && trigger.timeTrigger().isEmpty()
                    && !awaited.contains(trigger.name());
            if (any) {
                acts.add(act(transition));
            }
        }
        return acts;
    }

    private static Stimulus act(Transition transition) {
        Event event = transition.event();
        return new Stimulus(Stimulus.Kind.ACT, event.trigger(), -1, Set.copyOf(event.guards()));
    }

    /** Whether somebody presses it, and not only the device, a timer or a function raises it. */
    boolean isPress(Stimulus stimulus) {
        Event event = stimulus.event();
        return event != null
                && (stimulus.kind() == Stimulus.Kind.PRESS
                        || (stimulus.kind() == Stimulus.Kind.ACT && !table.isDevicesOwn(event)))
                && !awaited.contains(event.name());
    }

    /** The ways in which what is awaited comes. */
    List<Stimulus> arrivals(int coming, Situation situation) {
        Assumption.Comes comes = comings.get(coming);
        Event event = new Event(comes.event());
        if (table.isDevicesOwn(event)) {
            List<Stimulus> acts = new ArrayList<>();
            for (Transition transition :
                    table.models().original().transitionsFrom(situation.at().original())) {
                if (transition.event().trigger().equals(event)) {
                    acts.add(act(transition));
                }
            }
            return acts.isEmpty() ? List.of(Stimulus.of(Stimulus.Kind.ACT, event)) : acts;
        }
        boolean raised = comes.during().kind() != Formula.Kind.DEVICE
                && table.isNew(situation.at().evolved());
        return List.of(Stimulus.of(raised ? Stimulus.Kind.RAISE : Stimulus.Kind.PRESS, event));
    }

    /** Whether the converter's own timer replaces what the device would report. */
    static boolean isTimed(Assumption.Comes comes, Situation situation) {
        return situation.timers.contains(new Event(comes.event()));
    }
}
