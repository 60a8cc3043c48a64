package org.evoloop.check.timing;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.check.temporal.Moment;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Sentry;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Watches the time properties of an evolution while it runs, with the same monitors as the check. What a property
 * observes of a configuration and an event is computed once; after that, nothing is allocated.
 *
 * <p>It begins in the models' initial states, as the check does, or in others. The events that led there are then
 * unknown, and nothing counts as violated there.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class TimeWatch implements Sentry {
    private final ModelPair pair;
    private final TimeRules rules;
    private final TimeForm[] forms;
    private final TimeMonitor[] monitors;

    /** How many violations of each are not reported yet. */
    private final int[] violated;

    private final Map<Configuration, int[]> lasting = new HashMap<>();
    private final Map<Event, Map<Configuration, int[]>> coming = new HashMap<>();
    private final Set<Event> known;
    private Configuration at;
    private long now;

    /** Starts watching the rules for {@code pair}. */
    public TimeWatch(TimeRules rules, ModelPair pair, Configuration at, long atNanos) {
        this.rules = rules;
        this.pair = pair;
        this.at = at;
        this.now = atNanos;
        this.known = pair.evolved().triggers();
        int count = rules.properties().size();
        forms = new TimeForm[count];
        monitors = new TimeMonitor[count];
        violated = new int[count];
        for (int index = 0; index < count; index++) {
            forms[index] = rules.properties().get(index).form();
            monitors[index] = TimeMonitor.of(forms[index], 1);
        }
        see(codes(null));
        if (!at.equals(pair.initial())) {
            Arrays.fill(violated, 0);
        }
    }

    @Override
    public void comes(Event event, Configuration where, long atNanos) {
        passed(atNanos);
        at = where;
        if (!known.contains(event.trigger())) {
            return;
        }
        see(codes(event));
        see(codes(null));
    }

    @Override
    public void moved(Configuration where, long atNanos) {
        passed(atNanos);
        at = where;
        see(codes(null));
    }

    @Override
    public void passed(long atNanos) {
        // An earlier observation may be reported later.
        now = Math.max(now, atNanos);
        for (int index = 0; index < monitors.length; index++) {
            while (monitors[index].lapsed(now)) {
                violated[index]++;
            }
        }
    }

    private void see(int[] codes) {
        for (int index = 0; index < monitors.length; index++) {
            violated[index] += monitors[index].sees(now, (codes[index] & 1) != 0, (codes[index] & 2) != 0) ? 1 : 0;
        }
    }

    /** What each property sees in the present state: bit 0 the subject, bit 1 the other. */
    private int[] codes(@Nullable Event event) {
        Map<Configuration, int[]> found = lasting;
        if (event != null) {
            found = coming.get(event);
            if (found == null) {
                found = new HashMap<>();
                coming.put(event, found);
            }
        }
        int[] codes = found.get(at);
        if (codes == null) {
            codes = new int[forms.length];
            Moment moment = new Moment(at, event);
            for (int index = 0; index < forms.length; index++) {
                codes[index] = (forms[index].subject().isSeenIn(moment, pair) ? 1 : 0)
                        | (forms[index].other().isSeenIn(moment, pair) ? 2 : 0);
            }
            found.put(at, codes);
        }
        return codes;
    }

    @Override
    public long dueNanos() {
        long due = NEVER;
        for (int index = 0; index < monitors.length; index++) {
            long deadline = violated[index] > 0 ? now - 1 : monitors[index].deadline();
            // At the deadline itself the property may still be satisfied.
            due = deadline == TimeMonitor.NONE ? due : Math.min(due, deadline + 1);
        }
        return due;
    }

    @Override
    public @Nullable Violation poll() {
        for (int index = 0; index < violated.length; index++) {
            if (violated[index] > 0) {
                violated[index]--;
                String name = rules.properties().get(index).name();
                return new Violation(name, raised(name));
            }
        }
        return null;
    }

    private @Nullable Event raised(String property) {
        for (Reaction reaction : rules.reactions()) {
            if (reaction.property().equals(property)) {
                return reaction.event();
            }
        }
        return null;
    }
}
