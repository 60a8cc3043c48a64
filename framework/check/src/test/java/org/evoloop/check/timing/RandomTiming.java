package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.evoloop.check.CheckInput;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/**
 * A small random evolution with one time property: two states of the device and two new ones with timers, steps that
 * take time, and no queue.
 */
record RandomTiming(ModelPair pair, PropertyFile file) {
    private static final List<String> DEVICE = List.of("A", "B");
    private static final List<String> ALL = List.of("A", "B", "X", "Y");
    private static final List<String> EVENTS = List.of("a", "b", "c");

    /** The evolution of this seed; empty if it cannot be carried out. */
    static Optional<RandomTiming> of(long seed) {
        Random random = new Random(seed);
        StateMachineBuilder original = StateMachine.named("original").initial("A");
        StateMachineBuilder evolved = StateMachine.named("new").initial("A");
        for (String state : DEVICE) {
            for (String event : EVENTS.subList(0, 2)) {
                if (random.nextInt(4) > 0) {
                    original.transition(state, event, pick(DEVICE, random));
                }
            }
        }
        for (String state : ALL) {
            for (String event : EVENTS) {
                if (random.nextInt(3) > 0) {
                    evolved.transition(state, event, pick(ALL, random));
                }
            }
        }
        for (String state : ALL.subList(2, 4)) {
            if (random.nextInt(4) > 0) {
                evolved.transition(state, "after " + (1 + random.nextInt(4)) + " s", pick(ALL, random));
            }
        }
        try {
            ModelPair pair = new ModelPair(original.build(), evolved.build());
            pair.requireValid();
            DecisionTable table =
                    DecisionTable.compile(pair, CheckInput.of(pair).device());
            boolean works = table.problems().isEmpty() && table.hazards().isEmpty();
            return works
                    ? Optional.of(new RandomTiming(pair, PropertyFile.parse("random", text(random), pair)))
                    : Optional.empty();
        } catch (ModelException unfit) {
            return Optional.empty();
        }
    }

    private static String text(Random random) {
        List<String> lines = new ArrayList<>(List.of("queue 0"));
        for (String event : EVENTS.subList(0, 2)) {
            int least = random.nextInt(3);
            lines.add("takes " + event + " " + least + " s .. " + (least + random.nextInt(3)) + " s");
        }
        lines.add("at least " + (1 + random.nextInt(3)) + " s between presses");
        lines.add(property(random));
        return String.join("\n", lines);
    }

    private static String property(Random random) {
        String one = (random.nextBoolean() ? "" : "device ") + pick(DEVICE, random);
        String state = random.nextBoolean() ? one : pick(ALL, random);
        String subject = random.nextInt(3) == 0 ? "event " + pick(EVENTS, random) : state;
        int length = random.nextInt(7);
        return switch (random.nextInt(4)) {
            case 0 ->
                "after " + subject + ", " + pick(ALL, random) + " or " + pick(ALL, random) + " within " + length + " s";
            case 1 -> state + " never longer than " + (length + 1) + " s";
            case 2 -> state + " never shorter than " + (length + 1) / 2.0 + " s";
            default -> subject + " at most 1 times in " + length + " s";
        };
    }

    private static String pick(List<String> of, Random random) {
        return of.get(random.nextInt(of.size()));
    }
}
