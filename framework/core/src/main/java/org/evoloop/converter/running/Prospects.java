package org.evoloop.converter.running;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.converter.Prospect;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * What can happen next, for those who look at a converter; nothing of it is computed for an event.
 *
 * @param doubtful the step in doubt; null if it is about none
 * @param ofControllers see {@link ControllerEvents}
 */
record Prospects(
        DecisionTable table,
        Configuration at,
        @Nullable Step doubtful,
        StateKnowledge knowledge,
        Set<Event> ofControllers) {

    Prospect compute() {
        return new Prospect(at, events(), Optional.ofNullable(doubtful));
    }

    private List<Prospect.Next> events() {
        Map<Event, Duration> timers = Friends.KNOWLEDGE.of(knowledge).timersOf(at.evolved());
        Map<Event, List<Decision>> coming = new LinkedHashMap<>();
        ofControllers.forEach(event -> coming.put(event, new ArrayList<>()));
        for (Turn turn : table.expected(at)) {
            if (!turn.isSent()) {
                coming.computeIfAbsent(turn.event().trigger(), event -> new ArrayList<>())
                        .add(turn.decision());
            }
        }
        List<Prospect.Next> events = new ArrayList<>();
        coming.forEach((event, decisions) -> events.add(new Prospect.Next(
                event,
                timers.containsKey(event)
                        ? Source.TIMER
                        : ofControllers.contains(event) ? Source.CONTROLLER : own(event),
                decisions.isEmpty() && table.defers(at, event),
                Optional.ofNullable(timers.get(event)),
                decisions)));
        return events;
    }

    private Source own(Event event) {
        boolean ofFunction =
                table.isNew(at.evolved()) && !table.device().spontaneous().contains(event);
        return ofFunction ? Source.FUNCTION : Source.DEVICE;
    }
}
