package org.evoloop.migration;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Timers;
import org.evoloop.migration.Carried.How;
import org.evoloop.migration.Carried.What;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * How the timers and the function of a state are carried over.
 *
 * <p>Threading: immutable.
 */
final class CarryOver {
    private final DecisionTable running;
    private final Timers runningTimers;
    private final DecisionTable next;
    private final Timers nextTimers;
    private final Mapping mapping;

    CarryOver(DecisionTable running, Timers runningTimers, DecisionTable next, Timers nextTimers, Mapping mapping) {
        this.running = running;
        this.runningTimers = runningTimers;
        this.next = next;
        this.nextTimers = nextTimers;
        this.mapping = mapping;
    }

    /**
     * The fates: timers first, those of {@code from} before those that only {@code to} has.
     *
     * @param atOnce whether nothing has to be sent before {@code to} begins; else no function runs meanwhile, and a timer
     *     of a state that needs the device somewhere does not keep the time before the device was there
     */
    List<Carried> carried(State from, State to, boolean atOnce) {
        List<Carried> all = new ArrayList<>();
        Set<String> begun = new LinkedHashSet<>(names(nextTimers, to));
        for (String timer : names(runningTimers, from)) {
            Mapping.TimerOf key = new Mapping.TimerOf(plain(from), timer);
            String becomes = mapping.timers().getOrDefault(key, timer);
            boolean continues = begun.remove(becomes);
            boolean anew = mapping.restartedTimers().contains(key) || (!atOnce && next.needsDevice(to));
            How how = !continues ? How.ENDED : anew ? How.RESTARTED : How.KEPT;
            all.add(new Carried(What.TIMER, timer, continues ? becomes : timer, how));
        }
        begun.forEach(timer -> all.add(new Carried(What.TIMER, timer, timer, How.STARTED)));
        functions(from, to, atOnce, all);
        return all;
    }

    private void functions(State from, State to, boolean atOnce, List<Carried> all) {
        String before = running.isNew(from) ? function(running.models().evolved(), from) : "";
        String after = next.isNew(to) ? function(next.models().evolved(), to) : "";
        boolean same = !before.isEmpty()
                && !after.isEmpty()
                && (before.equals(after) || mapping.keptFunctions().contains(plain(from)));
        if (same) {
            boolean anew = !atOnce || mapping.restartedFunctions().contains(plain(from));
            all.add(new Carried(What.FUNCTION, before, after, anew ? How.RESTARTED : How.KEPT));
            return;
        }
        if (!before.isEmpty()) {
            all.add(new Carried(What.FUNCTION, before, before, How.ENDED));
        }
        if (!after.isEmpty()) {
            all.add(new Carried(What.FUNCTION, after, after, How.STARTED));
        }
    }

    private State plain(State from) {
        return running.models().evolved().withoutMemory(from);
    }

    private static List<String> names(Timers timers, State state) {
        return timers.of(state).keySet().stream().map(Event::name).toList();
    }

    private static String function(StateMachine machine, State state) {
        List<String> activities = machine.activities(state);
        return activities.isEmpty() ? machine.withoutMemory(state).name() : String.join(", ", activities);
    }
}
