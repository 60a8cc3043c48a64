package org.evoloop.check.timing;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.evoloop.check.temporal.Formula;
import org.evoloop.engine.Rules;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * The clocks of a situation, in ticks, and their places in a row of numbers: the situation, the age of the step being
 * sent, the remaining time of each timer, the time since controls were pressed, the age of each awaited event,
 * violations with pending reactions, and the monitors' memory.
 */
final class Clocks {
    /** Places in the row. */
    static final int SITUATION = 0;

    static final int STEP = 1;
    static final int TIMERS = 2;

    final Ticks ticks;
    final List<Assumption.Gap> gaps;
    final List<Assumption.Comes> comings;
    final List<TimeMonitor> monitors;
    final Map<String, Span> takes;

    /** First places in the row. */
    final int gapsAt;

    final int comingsAt;
    final int owedAt;
    final int monitorsAt;
    final Packing packing;
    final int length;

    private final List<Integer> largest = new ArrayList<>();

    Clocks(Rules rules, TimeRules written, Ticks ticks, List<TimeForm> forms, Map<String, Span> takes) {
        ModelPair pair = rules.table().models();
        this.ticks = ticks;
        this.takes = takes;
        this.gaps = written.assumptions(Assumption.Gap.class);
        this.comings = comings(pair, written);
        this.monitors = forms.stream()
                .map(form -> TimeMonitor.ofFirst(form, ticks.nanos()))
                .toList();
        largest.add(Exploration.MOST_SITUATIONS);
        largest.add(takes.values().stream()
                .mapToInt(span -> ticks.of(span.maxNanos()))
                .max()
                .orElse(0));
        int timers = 0;
        int longest = 0;
        for (State state : pair.evolved().states()) {
            timers = Math.max(timers, rules.timers().of(state).size());
            for (var delay : rules.timers().of(state).values()) {
                longest = Math.max(longest, ticks.of(delay.toNanos()));
            }
        }
        add(timers, longest);
        gapsAt = largest.size();
        gaps.forEach(gap -> largest.add(ticks.of(gap.minNanos())));
        comingsAt = largest.size();
        comings.forEach(comes -> largest.add(ticks.of(comes.span().maxNanos()) + 2));
        owedAt = largest.size();
        add(monitors.size(), 1);
        monitorsAt = largest.size();
        for (int index = 0; index < monitors.size(); index++) {
            largest.add(3);
            long most = forms.get(index).nanos().stream()
                    .mapToLong(Long::longValue)
                    .max()
                    .orElse(0);
            add(monitors.get(index).marks.length, ticks.of(most) + 3);
        }
        packing = new Packing(largest);
        length = largest.size();
    }

    private void add(int places, int most) {
        for (int place = 0; place < places; place++) {
            largest.add(most);
        }
    }

    /** The written assumptions, and the device's own time triggers. */
    private static List<Assumption.Comes> comings(ModelPair pair, TimeRules written) {
        List<Assumption.Comes> comings = new ArrayList<>(written.assumptions(Assumption.Comes.class));
        for (State state : pair.original().states()) {
            pair.original()
                    .timers(state)
                    .forEach((Event event, Duration delay) -> comings.add(new Assumption.Comes(
                            event.name(),
                            new Span(delay.toNanos(), delay.toNanos()),
                            new Formula.Atom(Formula.Kind.DEVICE, state.name()))));
        }
        return comings;
    }

    int min(Assumption.Comes comes) {
        return ticks.of(comes.span().minNanos());
    }

    int max(Assumption.Comes comes) {
        return ticks.of(comes.span().maxNanos());
    }

    /** Fills the monitors from a row at time {@link #NOW}. */
    void recall(int[] row) {
        int place = monitorsAt;
        for (TimeMonitor monitor : monitors) {
            monitor.seen = row[place++];
            for (int mark = 0; mark < monitor.marks.length; mark++) {
                int age = row[place++];
                monitor.marks[mark] = age == 0 ? TimeMonitor.NONE : NOW - (age - 1);
            }
        }
    }

    /** The time at which rows are evaluated: late enough for every age to begin after 0. */
    static final long NOW = 1L << 40;

    /** Writes the monitors' memory at {@code now} into a row. */
    void note(int[] row, long now) {
        int place = monitorsAt;
        for (TimeMonitor monitor : monitors) {
            monitor.forget(now);
            row[place++] = monitor.seen;
            for (long mark : monitor.marks) {
                row[place++] = mark == TimeMonitor.NONE ? 0 : (int) (now - mark) + 1;
            }
        }
    }
}
