package org.evoloop.engine;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Carried;
import org.evoloop.migration.Carried.How;
import org.evoloop.migration.Carried.What;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Succession;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Lets other models take over between two events, translating the whole state into their terms. */
final class Takeover {
    private final Ledger ledger;

    Takeover(Ledger ledger) {
        this.ledger = ledger;
    }

    /** What prevents the models of {@code swap} from taking over now, for people; empty if nothing does. */
    String hindrance(Swap swap) {
        String obstacle = obstacle();
        return obstacle.isEmpty() && swap.succession().fate(ledger.place.at()) instanceof Fate.Stuck stuck
                ? stuck.because()
                : obstacle;
    }

    /** What prevents any models from taking over now. */
    private String obstacle() {
        Doubt doubt = ledger.place.lastDoubt();
        if (ledger.progress.isInterrupted()) {
            return "the plan for " + ledger.progress.pending().occurrence().label()
                    + " was interrupted; it goes on when the converter is started";
        } else if (!ledger.progress.isIdle() || ledger.mailbox.holdsRetry()) {
            return "an event is in progress";
        }
        return doubt != null && (!doubt.settled() || doubt.isReported())
                ? "the device's state is in doubt: " + doubt.why()
                : "";
    }

    /** Lets the models take over; does nothing if anything {@linkplain #hindrance prevents} that. */
    void take(Swap swap) {
        if (obstacle().isEmpty() && swap.succession().fate(ledger.place.at()) instanceof Fate.Maps maps) {
            take(swap, maps);
        }
    }

    private void take(Swap swap, Fate.Maps maps) {
        Configuration before = ledger.place.at();
        Occurrence.Evolved evolved = new Occurrence.Evolved(swap.name(), ledger.nowNanos);
        boolean settled = maps.steps().isEmpty();
        ledger.rules = swap.rules();
        ledger.out.evolved(evolved, before, maps);
        ledger.place.doubt(doubt(swap.succession(), maps));
        ledger.place.move(maps.at(), ledger.out);
        boolean continues = ledger.stay.isOver() || !ledger.open || (settled && keepsFunction(maps));
        line(swap.succession(), maps, continues);
        stay(swap.succession(), maps, continues);
        ledger.followOwed |= settled && !maps.to().equals(maps.at());
        if (!settled) {
            ledger.mailbox.addFirst(new Pending(ledger.counts.observe(), evolved, null, null, ledger.place.steps(), 0));
        }
    }

    private static boolean keepsFunction(Fate.Maps maps) {
        return maps.carried().stream().allMatch(each -> each.part() == What.TIMER || each.how() == How.KEPT);
    }

    /**
     * The doubt in the new terms. A settled one is kept while its step may still be reported to have had its effect.
     */
    private @Nullable Doubt doubt(Succession succession, Fate.Maps maps) {
        Doubt doubt = ledger.place.lastDoubt();
        Step before = doubt == null ? null : doubt.step();
        Step step = before == null ? null : succession.step(before);
        if (doubt == null || step == null) {
            return null;
        }
        List<Occurrence> meanwhile = doubt.meanwhile().stream()
                .map(fact -> in(fact, succession, maps))
                .toList();
        return doubt.of(step, meanwhile);
    }

    // The queue

    private void line(Succession succession, Fate.Maps maps, boolean continues) {
        ledger.mailbox.replace(pending -> {
            if (!isOver(pending.occurrence(), maps, continues)) {
                return in(pending, succession, maps);
            }
            String why = "what raised it ended with the previous models";
            ledger.ended(pending.occurrence(), ledger.place.at(), Outcome.STALE, null, why);
            return null;
        });
    }

    /** Whether the function or timer that raised it is not carried over. */
    private boolean isOver(Occurrence occurrence, Fate.Maps maps, boolean continues) {
        if (occurrence.visit() == Occurrence.ANY_VISIT || !ledger.stay.isCurrent(occurrence.visit())) {
            return false;
        }
        boolean timer = occurrence instanceof Occurrence.Heard heard && heard.source() == Source.TIMER;
        return timer ? kept(maps, ((Occurrence.Heard) occurrence).event()) == null : !continues;
    }

    private Pending in(Pending pending, Succession succession, Fate.Maps maps) {
        State from = pending.from() == null ? null : succession.deviceState(pending.from());
        boolean lost = pending.from() != null && from == null;
        Step own = pending.own() == null || lost ? null : succession.step(pending.own());
        return new Pending(
                pending.number(),
                in(pending.occurrence(), succession, maps),
                lost ? maps.at().original() : from,
                own,
                pending.stepsBefore(),
                pending.attempts());
    }

    private Occurrence in(Occurrence occurrence, Succession succession, Fate.Maps maps) {
        if (occurrence instanceof Occurrence.Found found) {
            State there = succession.deviceState(found.state());
            return new Occurrence.Found(there == null ? maps.at().original() : there, found.observedNanos());
        }
        Event kept = occurrence instanceof Occurrence.Heard heard
                        && heard.source() == Source.TIMER
                        && ledger.stay.isCurrent(heard.visit())
                ? kept(maps, heard.event())
                : null;
        return kept == null ? occurrence : Reframed.as(kept, (Occurrence.Heard) occurrence);
    }

    // The visit

    /** The event under which a timer of the running models continues; null if it does not. */
    private @Nullable Event kept(Fate.Maps maps, Event timer) {
        for (Carried each : maps.carried()) {
            if (each.part() == What.TIMER
                    && each.how() == How.KEPT
                    && each.name().equals(timer.name())) {
                return each.name().equals(each.becomes()) ? timer : new Event(each.becomes());
            }
        }
        return null;
    }

    private void stay(Succession succession, Fate.Maps maps, boolean continues) {
        State state = maps.at().evolved();
        Transition by = succession.entry(state, ledger.stay.by());
        boolean wasOver = ledger.stay.isOver();
        Map<Event, Long> left = new LinkedHashMap<>();
        ledger.stay.inOrder().forEach((timer, deadline) -> {
            Event kept = kept(maps, timer);
            if (kept != null) {
                left.put(kept, deadline);
            }
        });
        Set<String> kept = new HashSet<>();
        for (Carried each : maps.carried()) {
            if (each.part() == What.TIMER && each.how() == How.KEPT) {
                kept.add(each.becomes());
            }
        }
        if (!continues) {
            ledger.stay.leave(ledger.out);
        }
        ledger.stay.proceed(state, by, left, kept, ledger.rules, ledger.nowNanos);
        long visit = ledger.stay.number();
        if (continues && !wasOver && ledger.open) {
            ledger.out.carryOver(visit, state, ledger.stay.inOrder());
        } else if (!continues && maps.steps().isEmpty()) {
            ledger.enterAsLeft();
            ledger.start(visit, false);
        }
    }
}
