package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;

/**
 * Which turns can come in a configuration.
 *
 * <p>Threading: immutable.
 */
final class Turns {
    private final ModelPair pair;
    private final DeviceEvents device;
    private final EventConversion conversion;
    private final GuardedTriggers originalGuards;
    private final GuardedTriggers evolvedGuards;

    /** Whether the device takes any event by itself that could be sent. */
    private final boolean interferes;

    Turns(
            ModelPair pair,
            DeviceEvents device,
            EventConversion conversion,
            GuardedTriggers originalGuards,
            GuardedTriggers evolvedGuards) {
        this.pair = pair;
        this.device = device;
        this.conversion = conversion;
        this.originalGuards = originalGuards;
        this.evolvedGuards = evolvedGuards;
        this.interferes = device.spontaneous().stream().anyMatch(device.sendable()::contains);
    }

    /** Decides an event in the configuration in question. */
    interface Decider {
        Decision decide(Event event, boolean deviceActed);
    }

    /** Events that the new model accepts, what the device does by itself, and what the state's function may send. */
    List<Turn> expected(Configuration at, Decider decider) {
        List<Turn> turns = new ArrayList<>();
        for (Transition transition : pair.evolved().transitionsFrom(at.evolved())) {
            if (evolvedGuards.shadowOf(transition) == null) {
                turns.add(turn(transition.event(), false, decider));
            }
        }
        for (Transition transition : pair.original().transitionsFrom(at.original())) {
            if (device.isOwn(transition.event().trigger()) && isUnheard(at, transition)) {
                turns.add(turn(transition.event(), false, decider));
            }
        }
        Set<Event> sent = pair.evolved().sends(at.evolved());
        if (!sent.isEmpty()) {
            addSent(turns, at, sent);
        }
        return turns;
    }

    private void addSent(List<Turn> turns, Configuration at, Set<Event> sent) {
        for (Transition transition : pair.original().transitionsFrom(at.original())) {
            if (sent.contains(transition.event().trigger()) && originalGuards.shadowOf(transition) == null) {
                boolean conditional = !originalGuards.conditionsOf(transition).isEmpty();
                Event trigger = transition.event().trigger();
                Turn turn = new Turn(transition.event(), false, conversion.send(at, trigger, transition, conditional));
                if (turn.isSent()) {
                    turns.add(turn);
                }
            }
        }
    }

    /** What the device does by itself although it could have been sent to it. */
    List<Turn> interference(Configuration at, Decider decider) {
        if (!interferes) {
            return List.of();
        }
        List<Turn> turns = new ArrayList<>();
        for (Transition transition : pair.evolved().transitionsFrom(at.evolved())) {
            if (isSpontaneous(transition)
                    && evolvedGuards.shadowOf(transition) == null
                    && conversion.originalTransition(at.original(), transition.event()) != null) {
                turns.add(turn(transition.event(), true, decider));
            }
        }
        for (Transition transition : pair.original().transitionsFrom(at.original())) {
            if (isSpontaneous(transition) && isUnheard(at, transition)) {
                turns.add(turn(transition.event(), true, decider));
            }
        }
        return turns;
    }

    private boolean isSpontaneous(Transition transition) {
        Event trigger = transition.event().trigger();
        return device.spontaneous().contains(trigger) && device.sendable().contains(trigger);
    }

    /** Whether the device may take {@code transition} although the new model does not accept its event. */
    private boolean isUnheard(Configuration at, Transition transition) {
        return originalGuards.shadowOf(transition) == null
                && !pair.evolved().hasTransition(at.evolved(), transition.event())
                && !pair.evolved()
                        .hasTransition(at.evolved(), transition.event().trigger());
    }

    private static Turn turn(Event event, boolean deviceActed, Decider decider) {
        return new Turn(event, deviceActed, decider.decide(event, deviceActed));
    }
}
