package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * The paper's Algorithm 1 as a pure function of the pair, both current states and the occurrence.
 *
 * <p>Where the paper leaves a question open: the original model moves along the events that are really sent (line 9
 * moves it by the incoming event, which it may not know); an occurrence that the device has already acted on moves it
 * first; and an event of the original model that nobody can send can only be one that the device took itself.
 *
 * <p>Threading: not thread-safe; its path planner remembers what it has searched.
 */
final class EventConversion {
    private final ModelPair pair;
    private final DeviceEvents device;
    private final PathPlanner planner;

    EventConversion(ModelPair pair, DeviceEvents device) {
        this.pair = pair;
        this.device = device;
        this.planner = new PathPlanner(pair.original(), device.sendable());
    }

    /** What {@code event} means in {@code before}. */
    Decision decide(Configuration before, Event event, boolean deviceActed) {
        List<Step> steps = new ArrayList<>();
        boolean taken = deviceActed
                || (pair.original().events().contains(event)
                        && !device.sendable().contains(event));
        Optional<Transition> own = taken ? pair.original().transition(before.original(), event) : Optional.empty();
        own.ifPresent(transition -> steps.add(new Step(transition.source(), event, transition.target(), true)));
        State original = own.map(Transition::target).orElse(before.original());

        Optional<State> next = pair.evolved().nextState(before.evolved(), event);
        if (next.isEmpty()) {
            return new Decision.NotAcceptable(before, before.withOriginal(original), List.copyOf(steps));
        }
        State target = next.get();
        if (pair.isNew(target)) {
            return new Decision.NewFunction(before, new Configuration(original, target), List.copyOf(steps));
        }
        Optional<List<Step>> way = taken ? planner.shortestPath(original, target) : wayFor(original, event, target);
        if (way.isEmpty()) {
            return new Decision.Impossible(
                    before, before.withOriginal(original), List.copyOf(steps), noWay(original, event, target));
        }
        steps.addAll(way.get());
        return new Decision.ExistingFunction(before, new Configuration(target, target), List.copyOf(steps));
    }

    /** The incoming event itself if it leads there, even from a state to itself; else the shortest way. */
    private Optional<List<Step>> wayFor(State original, Event event, State target) {
        boolean leadsThere = device.sendable().contains(event)
                && pair.original()
                        .nextState(original, event)
                        .filter(target::equals)
                        .isPresent();
        return leadsThere
                ? Optional.of(List.of(new Step(original, event, target, false)))
                : planner.shortestPath(original, target);
    }

    private String noWay(State original, Event event, State target) {
        return "event " + event + " leads to " + target + ", but with the device in " + original
                + " no events that can be sent take it there (sendable: "
                + (device.sendable().isEmpty() ? "none" : names()) + ")";
    }

    private String names() {
        return String.join(
                ", ", device.sendable().stream().map(Event::name).sorted().toList());
    }
}
