package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;

/**
 * A small random pair: a device with three states that can be sent {@code a} and {@code b} and does {@code a} and
 * {@code x} by itself, and a new model with two more states, one with a timer, and effects.
 */
public final class RandomPair {
    private static final List<String> DEVICE = List.of("A", "B", "C");
    private static final List<String> NEW = List.of("N", "W");

    private final Random random;

    private RandomPair(long seed) {
        random = new Random(seed);
    }

    static Scene scene(long seed) {
        OnFailure then = OnFailure.values()[Math.floorMod(seed, OnFailure.values().length)];
        return Scene.of("pair of seed " + seed, models(seed), Map.of("W", "late"), "a b", "a", 2)
                .onFailure(then);
    }

    /** The same, with new states that need the device somewhere, or send something. */
    static Scene needing(long seed) {
        Random random = new Random(seed);
        ModelPair same = models(seed);
        StateMachine evolved = same.evolved();
        for (String state : NEW) {
            State added = new State(state);
            if (random.nextInt(4) > 0) {
                evolved = evolved.withDeviceState(added, DEVICE.get(random.nextInt(DEVICE.size())));
            }
            if (random.nextInt(3) == 0) {
                evolved = evolved.withSends(added, new Event("a")).withSends(added, new Event("b"));
            }
        }
        OnFailure then = OnFailure.values()[Math.floorMod(seed, OnFailure.values().length)];
        ModelPair pair = new ModelPair(same.original(), evolved);
        return Scene.of("needing pair of seed " + seed, pair, Map.of("W", "late"), "a b", "a", 2)
                .onFailure(then)
                .pressing("done");
    }

    /** The pair of {@code seed}. */
    public static ModelPair models(long seed) {
        return new RandomPair(seed).draw();
    }

    /** The device of {@code seed} with the new model of another seed. */
    static Scene other(long seed, long another) {
        ModelPair pair = new ModelPair(models(seed).original(), models(another).evolved());
        return Scene.of("new model of seed " + another, pair, Map.of("W", "late"), "a b", "a", 2);
    }

    /** The same pair with a larger new model: it has another state, with transitions there and back. */
    static Scene more(long seed) {
        ModelPair same = models(seed);
        StateMachine evolved = same.evolved();
        StateMachineBuilder builder =
                StateMachine.named("more").initial(evolved.initial().name());
        evolved.states().forEach(state -> builder.state(state.name()));
        evolved.events().forEach(event -> builder.event(event.name()));
        evolved.transitions().forEach(transition -> builder.transition(transition, ""));
        builder.state("M");
        for (State state : evolved.states()) {
            builder.transition(state.name(), "more", "M");
            builder.transition("M", "to" + state, state.name());
        }
        ModelPair pair = new ModelPair(same.original(), builder.build());
        return Scene.of("more of seed " + seed, pair, Map.of("W", "late"), "a b", "a", 2);
    }

    private ModelPair draw() {
        List<String> all = new ArrayList<>(DEVICE);
        all.addAll(NEW);
        return new ModelPair(
                machine("original", DEVICE, List.of("a", "b", "x"), 0),
                machine("new", all, List.of("a", "b", "x", "late", "done"), 0.4));
    }

    private StateMachine machine(String name, List<String> states, List<String> events, double effectRate) {
        StateMachineBuilder builder = StateMachine.named(name).initial("A");
        states.forEach(builder::state);
        events.forEach(builder::event);
        for (String state : states) {
            for (String event : events) {
                if (random.nextInt(3) > 0) {
                    builder.transition(transition(state, event, pick(states), effectRate), "");
                } else if (effectRate > 0 && random.nextInt(4) == 0) {
                    builder.defers(state, new Event(event));
                }
            }
        }
        return builder.build();
    }

    private Transition transition(String source, String event, String target, double effectRate) {
        List<String> effects = random.nextDouble() < effectRate ? List.of("beep", "blink") : List.of();
        boolean internal = source.equals(target) && random.nextBoolean();
        return new Transition(new State(source), new Event(event), new State(target), effects, internal, Set.of());
    }

    private String pick(List<String> names) {
        return names.get(random.nextInt(names.size()));
    }
}
