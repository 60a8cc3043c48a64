package org.evoloop.study.proof;

import java.util.List;
import org.evoloop.engine.Doubt;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Work;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/** What a core knows, as {@code tell_state} of {@code prism/proof/core.pml} prints it. */
final class StateText {
    private final EvolvingPair evolution;
    private final Snapshot now;

    private StateText(EvolvingPair evolution, Snapshot now) {
        this.evolution = evolution;
        this.now = now;
    }

    /** @param swapped whether the other models count */
    static String of(EvolvingPair evolution, Snapshot now, boolean swapped) {
        return new StateText(evolution, now).write(swapped);
    }

    /** An occurrence as numbers: its event or state, its source, and its visit. */
    record Numbers(int what, int source, int visit) {}

    /** @param now the time before the input */
    static Numbers numbers(EvolvingPair evolution, Snapshot now, Occurrence occurrence) {
        StateText text = new StateText(evolution, now);
        return new Numbers(text.what(occurrence), source(occurrence), text.visit(occurrence));
    }

    private String write(boolean swapped) {
        StringBuilder all = new StringBuilder("= ");
        all.append(numbers(
                bit(now.open()),
                evolution.number(now.at().original(), true),
                evolution.number(now.at().evolved(), false),
                bit(swapped),
                bit(now.visit().over()),
                bit(!now.visit().deadlines().isEmpty()),
                bit(now.steps() > 0),
                bit(now.followOwed()) + 2 * bit(now.visit().startOwed())));
        all.append(" doubt ").append(doubt(now.doubt())).append(" work ").append(work(now.work()));
        for (Pending pending : now.waiting()) {
            all.append(text(pending));
        }
        return all.toString();
    }

    private static String numbers(long... numbers) {
        StringBuilder all = new StringBuilder();
        for (long number : numbers) {
            all.append(all.isEmpty() ? "" : " ").append(number);
        }
        return all.toString();
    }

    private static int bit(boolean value) {
        return value ? 1 : 0;
    }

    private String doubt(@Nullable Doubt doubt) {
        if (doubt == null) {
            return "0 0 0 0";
        }
        int steps = doubt.stepsBefore() < 0 ? 2 : doubt.stepsBefore() == now.steps() ? 0 : 1;
        return numbers(
                (doubt.settled() ? 2 : 1) + (doubt.interrupted() == null ? 0 : 2),
                doubt.number(),
                steps,
                doubt.meanwhile().size());
    }

    private String work(@Nullable Work work) {
        if (work == null) {
            return "0 0 0 0 0 0 [0 0 0 0 0 0 0 0 0 0]";
        }
        Decision decision = work.decision();
        int stage = List.of(Work.Stage.READY, Work.Stage.SENDING, Work.Stage.INTERRUPTED, Work.Stage.RESUMED)
                .indexOf(work.stage());
        return numbers(
                        1,
                        bit(decision != null),
                        decision == null ? 0 : Codes.of(decision, evolution),
                        stage,
                        work.stepsSent(),
                        work.meanwhile().size())
                + text(work.pending());
    }

    private String text(Pending pending) {
        Occurrence occurrence = pending.occurrence();
        Step own = pending.own();
        return " ["
                + numbers(
                        pending.number(),
                        kind(occurrence),
                        what(occurrence),
                        source(occurrence),
                        visit(occurrence),
                        device(pending.from()),
                        own == null ? 0 : device(own.target()),
                        pending.attempts(),
                        bit(occurrence instanceof Occurrence.Heard heard && heard.deviceActed()),
                        bit(pending.stepsBefore() != now.steps()))
                + "]";
    }

    private int device(@Nullable State state) {
        return state == null ? 0 : evolution.number(state, true);
    }

    private static int kind(Occurrence occurrence) {
        return occurrence instanceof Occurrence.Heard
                ? 1
                : occurrence instanceof Occurrence.Found
                        ? 2
                        : occurrence instanceof Occurrence.Asked ? 3 : occurrence instanceof Occurrence.Evolved ? 4 : 5;
    }

    private int what(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            return evolution.number(heard.event());
        } else if (occurrence instanceof Occurrence.Asked asked) {
            return evolution.number(asked.event());
        }
        return occurrence instanceof Occurrence.Found found ? device(found.state()) : 0;
    }

    private static int source(Occurrence occurrence) {
        Source source = occurrence.source();
        return source.isButton() ? 1 : source == Source.TIMER ? 3 : source == Source.FUNCTION ? 4 : 2;
    }

    private int visit(Occurrence occurrence) {
        if (occurrence.visit() == Occurrence.ANY_VISIT) {
            return 0;
        }
        return occurrence.visit() == now.visit().number() ? 1 : 2;
    }
}
