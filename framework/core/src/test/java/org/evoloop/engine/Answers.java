package org.evoloop.engine;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;

/** What guards may answer: those that hold, in every combination. They answer anew whenever they are evaluated. */
final class Answers {
    private Answers() {}

    /** Of the guards of both models. */
    static List<Set<String>> of(ModelPair pair) {
        Set<String> guards = new HashSet<>(pair.original().guards());
        guards.addAll(pair.evolved().guards());
        return ofAll(guards);
    }

    /** Of the guards that the original model draws for {@code trigger}: a fact comes with their answers. */
    static List<Set<String>> of(ModelPair pair, Event trigger) {
        Set<String> guards = new HashSet<>();
        for (Event event : pair.original().events()) {
            if (event.trigger().equals(trigger)) {
                guards.addAll(event.guards());
            }
        }
        return ofAll(guards);
    }

    private static List<Set<String>> ofAll(Set<String> guards) {
        List<Set<String>> all = new ArrayList<>();
        all.add(Set.of());
        for (String guard : guards) {
            for (Set<String> holding : List.copyOf(all)) {
                Set<String> more = new HashSet<>(holding);
                more.add(guard);
                all.add(more);
            }
        }
        return all;
    }
}
