package org.evoloop.models;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/** Comma-separated names of a model's elements on the command line. */
final class KnownNames {
    private KnownNames() {}

    /**
     * The names in {@code given}. A name may itself contain commas, as guards and effects do.
     *
     * @param given the texts between the commas
     * @param known the existing names
     * @param what the names are of, for messages: {@code event of the original model}
     * @throws IllegalArgumentException listing the unknown names and the known ones
     */
    static Set<String> resolve(String option, List<String> given, Collection<String> known, String what) {
        Set<String> resolved = new LinkedHashSet<>();
        List<String> unknown = new ArrayList<>();
        for (int from = 0; from < given.size(); ) {
            int to = given.size();
            while (to > from + 1 && !known.contains(joined(given, from, to))) {
                to--;
            }
            String name = joined(given, from, to);
            if (known.contains(name)) {
                resolved.add(name);
            } else if (!name.isEmpty()) {
                unknown.add(name);
            }
            from = to;
        }
        if (!unknown.isEmpty()) {
            throw new IllegalArgumentException(option + ": there is no " + what + " named "
                    + String.join(", ", unknown) + "; choose from: "
                    + (known.isEmpty() ? "none" : String.join(", ", known)));
        }
        return resolved;
    }

    /**
     * The names of states, with and without the memory of the machine. A name without it means every state that differs
     * only in memory.
     */
    static Set<String> states(StateMachine machine) {
        Set<String> names = new LinkedHashSet<>();
        for (State state : machine.states()) {
            names.add(machine.withoutMemory(state).name());
            names.add(state.name());
        }
        return names;
    }

    private static String joined(List<String> given, int from, int to) {
        return String.join(",", given.subList(from, to)).strip();
    }
}
