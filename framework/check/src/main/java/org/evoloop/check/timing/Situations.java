package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.check.timing.Situation.Branch;
import org.evoloop.engine.Core;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.statemachine.Event;

/**
 * All situations of a converter and their successors, computed by the converter's own core, one input at a time.
 */
final class Situations {
    private final Rules rules;
    private final Set<String> slow;
    private final Map<Snapshot, Situation> known = new HashMap<>();
    private final List<Situation> all = new ArrayList<>();

    /** @param slow the events that the device takes time to obey; the others it obeys at once */
    Situations(Rules rules, Set<String> slow) {
        this.rules = rules;
        this.slow = slow;
    }

    Situation number(int number) {
        return all.get(number);
    }

    int size() {
        return all.size();
    }

    /** The ways in which a converter can be opened. */
    List<Branch> opening() {
        Snapshot closed = new Core(rules, output -> {}).snapshot();
        return ways(chooser -> new Turnover(rules, closed, slow, chooser).open());
    }

    /** What can follow when {@code stimulus} happens. */
    List<Branch> after(Situation situation, Stimulus stimulus) {
        return ways(chooser -> new Turnover(rules, due(situation, stimulus), slow, chooser).take(stimulus));
    }

    private interface Way {
        Turnover take(Chooser chooser);
    }

    private List<Branch> ways(Way way) {
        Set<Branch> branches = new LinkedHashSet<>();
        Chooser chooser = new Chooser();
        do {
            branches.add(branch(way.take(chooser)));
        } while (chooser.next());
        return List.copyOf(branches);
    }

    /** The snapshot in which a timer that runs is due. */
    private static Snapshot due(Situation situation, Stimulus stimulus) {
        Snapshot now = situation.snapshot;
        if (stimulus.timer() < 0) {
            return now;
        }
        Map<Event, Long> deadlines = new LinkedHashMap<>(now.visit().deadlines());
        deadlines.put(situation.timers.get(stimulus.timer()), 0L);
        return new Snapshot(
                now.open(),
                now.at(),
                now.doubt(),
                now.steps(),
                now.lastStepNanos(),
                now.visit().withDeadlines(deadlines),
                now.waiting(),
                now.losing(),
                now.followOwed(),
                now.work(),
                now.tally(),
                now.nowNanos());
    }

    private Branch branch(Turnover turnover) {
        Snapshot after = turnover.snapshot();
        Snapshot like = Likeness.of(after, turnover.visitBefore());
        Situation target = known.computeIfAbsent(like, this::add);
        List<Long> timers = new ArrayList<>();
        for (Event timer : target.timers) {
            long deadline = after.visit().deadlines().getOrDefault(timer, 0L);
            int place = Likeness.place(deadline);
            timers.add(place >= 0 ? -1L - place : Math.max(0, deadline));
        }
        boolean enters = after.visit().number() != turnover.visitBefore();
        return new Branch(target, turnover.sights(), List.copyOf(timers), turnover.hasSent(), enters);
    }

    private Situation add(Snapshot snapshot) {
        List<Event> timers = List.copyOf(snapshot.visit().deadlines().keySet());
        boolean[] heard = new boolean[timers.size()];
        for (int place = 0; place < heard.length; place++) {
            heard[place] = snapshot.visit().deadlines().getOrDefault(timers.get(place), 0L) == Likeness.HEARD;
        }
        Situation situation = new Situation(all.size(), snapshot, timers, heard);
        all.add(situation);
        return situation;
    }
}
