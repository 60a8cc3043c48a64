package org.evoloop.models.temporal;

import java.util.List;
import java.util.Random;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Formula.Atom;
import org.evoloop.check.temporal.Formula.Kind;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/** Small evolutions and formulas over them, for tests. */
final class RandomModels {
    private static final int STATES = 4;
    private static final int NEW_STATES = 2;

    private RandomModels() {}

    /** A device with four states and two events, and a new model with two more states and one more event. */
    static ModelPair pair(Random random) {
        return new ModelPair(
                machine(random, "original", STATES, List.of("a", "b")),
                machine(random, "new", STATES + NEW_STATES, List.of("a", "b", "c")));
    }

    private static StateMachine machine(Random random, String name, int states, List<String> events) {
        StateMachineBuilder builder = StateMachine.named(name).initial("S0");
        for (int state = 0; state < states; state++) {
            builder.state("S" + state);
            for (String event : events) {
                if (random.nextInt(3) > 0) {
                    builder.transition("S" + state, event, "S" + random.nextInt(states));
                }
            }
        }
        events.forEach(builder::event);
        return builder.build();
    }

    static Formula formula(Random random, int depth) {
        if (depth == 0) {
            return atom(random);
        }
        Formula left = formula(random, depth - 1);
        Formula right = formula(random, random.nextInt(depth));
        return switch (random.nextInt(9)) {
            case 0 -> new Formula.Not(left);
            case 1 -> new Formula.And(left, right);
            case 2 -> new Formula.Or(left, right);
            case 3 -> new Formula.Always(left);
            case 4 -> new Formula.Can(left);
            case 5 -> new Formula.Eventually(left);
            case 6 -> new Formula.Next(left);
            case 7 -> new Formula.Unless(left, right);
            default -> new Formula.Until(left, right);
        };
    }

    /** A formula whose violation is shown by a finite sequence of events. */
    static Formula safety(Random random) {
        Formula left = state(random);
        Formula right = state(random);
        return switch (random.nextInt(6)) {
            case 0 -> new Formula.Always(left);
            case 1 -> new Formula.Unless(left, right);
            case 2 -> new Formula.Next(left);
            case 3 -> new Formula.Always(new Formula.Or(new Formula.Not(left), new Formula.Next(right)));
            case 4 -> new Formula.Not(new Formula.Can(state(random)));
            default -> new Formula.And(safety(random), safety(random));
        };
    }

    private static Formula state(Random random) {
        Formula atom = atom(random);
        return switch (random.nextInt(4)) {
            case 0 -> new Formula.Not(atom);
            case 1 -> new Formula.Can(atom);
            case 2 -> new Formula.Or(atom, atom(random));
            default -> atom;
        };
    }

    private static Atom atom(Random random) {
        return switch (random.nextInt(6)) {
            case 0 -> new Atom(Kind.EVENT, List.of("a", "b", "c").get(random.nextInt(3)));
            case 1 -> new Atom(Kind.DEVICE, "S" + random.nextInt(STATES));
            case 2 -> new Atom(Kind.FUNCTION, "S" + (STATES + random.nextInt(NEW_STATES)));
            default -> new Atom(Kind.STATE, "S" + random.nextInt(STATES + NEW_STATES));
        };
    }
}
