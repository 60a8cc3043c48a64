package org.evoloop.converter.running;

import java.util.Locale;
import java.util.Objects;
import java.util.function.Supplier;
import org.evoloop.converter.recording.Records;
import org.evoloop.engine.Output;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Pending;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.loop.Intake.Admission;
import org.evoloop.migration.Fate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Receives the core's outputs: directives wait on the agenda until a thread carries them out, notices go into the
 * records.
 *
 * <p>Threading: guarded by the lock of its {@link CoreDriver}; {@link #at} may be called without it.
 */
final class CoreOutputs implements Outputs {
    Agenda agenda = new Agenda();

    /** The occurrence that had its turn last; null if none had. */
    @Nullable
    Pending begun;

    /** The admission of the last occurrence offered. */
    Admission admission = Admission.TAKEN;

    /** Whether the occurrence that had its turn last has ended by leading out of the state. */
    boolean left;

    /** Also receives the outputs; null if there is no shadow. */
    @Nullable
    Outputs shadow;

    private final CurrentKnowledge knowledge;
    private final Records records;
    private final Supplier<String> progress;
    private final SentryFeed sentryFeed;
    private volatile Configuration at;
    private Output.@Nullable Evolved evolution;

    /** The progress of the function that was left last, in words, and the number of the occurrence that left it. */
    private String leaving = "";

    private long leavingNumber;

    /** The last event, if neither model knows it. */
    private @Nullable Event unknown;

    /** @param progress that of the function that is about to be left, in words; empty if there is none */
    CoreOutputs(
            Configuration at,
            CurrentKnowledge knowledge,
            Records records,
            Supplier<String> progress,
            SentryFeed sentryFeed) {
        this.sentryFeed = sentryFeed;
        this.progress = progress;
        this.at = at;
        this.knowledge = knowledge;
        this.records = records;
    }

    /** Where device and evolved system are. */
    Configuration at() {
        return at;
    }

    @Override
    public void say(Output output) {
        if (output instanceof Output.Directive directive) {
            agenda.add(directive);
        }
        if (shadow != null) {
            shadow.say(output);
        }
    }

    @Override
    public void leave() {
        // Noted before it is carried out, since the event that ends the visit may end first.
        leaving = progress.get();
        leavingNumber = begun == null ? 0 : begun.number();
        agenda.add(Output.LEAVE);
        if (shadow != null) {
            shadow.leave();
        }
    }

    @Override
    public void begin(Pending pending) {
        begun = pending;
        left = false;
        records.flight().begun(pending.occurrence());
        records.transcript().observed(pending.occurrence());
        if (shadow != null) {
            shadow.begin(pending);
        }
    }

    @Override
    public void send(Step step) {
        agenda.add(new Output.Send(step));
        records.transcript().step(step);
        records.drift().sent(step);
        if (shadow != null) {
            shadow.send(step);
        }
    }

    @Override
    public void queued(Occurrence occurrence) {
        // It counts as taken unless another notice says otherwise.
        records.flight().observed(occurrence, "queued");
    }

    @Override
    public void dropped(Occurrence occurrence, boolean first) {
        admission = first ? Admission.FIRST_DROPPED : Admission.DROPPED;
        records.flight().observed(occurrence, "dropped");
        records.record(occurrence, at, at, Outcome.DROPPED, null, "the queue was full", "");
    }

    @Override
    public void refused(Occurrence occurrence) {
        admission = Admission.REFUSED;
        records.flight().observed(occurrence, "refused");
        records.listeners().endings().refused(occurrence, "the converter was stopped before its turn came");
    }

    @Override
    public void decided(Pending pending, Decision decision, long waitedNanos) {
        records.transcript().decided(decision);
        records.latency().record(waitedNanos);
        records.listeners().converted(waitedNanos);
        records.flight().decided(waitedNanos);
        if (shadow != null) {
            shadow.decided(pending, decision, waitedNanos);
        }
    }

    @Override
    public void overtaken(Occurrence occurrence, String why) {
        records.transcript().ended(occurrence, at);
    }

    @Override
    public void took(Step step) {
        records.transcript().command(step.trigger());
        records.drift().took(step);
        if (shadow != null) {
            shadow.took(step);
        }
    }

    @Override
    public void acted(Occurrence.Heard fact, State from, @Nullable Step own) {
        records.drift().acted(fact.event(), from, own);
    }

    @Override
    public void reported(State state, State recorded) {
        records.drift().reported(state, recorded);
    }

    @Override
    public void moved(Configuration before, Configuration after) {
        at = after;
        sentryFeed.moved(after);
        records.listeners().moved(before, after);
    }

    @Override
    public void evolved(Occurrence.Evolved occurrence, Configuration before, Fate.Maps fate) {
        records.transcript().evolved(occurrence);
        records.drift().begin();
        evolution = new Output.Evolved(occurrence, before, fate);
    }

    /** The last takeover; there must have been one. */
    Output.Evolved evolution() {
        return Objects.requireNonNull(evolution);
    }

    @Override
    public void doubted(String why) {
        if (!why.isEmpty()) {
            records.failures().warnSoon("the state of the device is in doubt: " + why);
        }
        records.listeners().doubted(why);
        if (shadow != null) {
            shadow.doubted(why);
        }
    }

    @Override
    public void ended(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail) {
        if (isBegun(occurrence)) {
            left = decision != null && decision.leavesState();
        }
        if (decision instanceof Decision.Impossible impossible) {
            records.failures().warnSoon(occurrence + " in " + before + ": " + impossible.reason());
        }
        if (occurrence instanceof Occurrence.Heard heard) {
            warnOfUnknown(heard, outcome, detail);
        } else if (occurrence instanceof Occurrence.Found && outcome == Outcome.FAILED) {
            records.failures().warnSoon(detail);
        } else if (occurrence instanceof Occurrence.Violated violated) {
            records.failures().warnSoon("'" + violated.property() + "' is violated in " + after);
            records.transcript().violated(violated);
        }
        records.transcript().ended(occurrence, after);
        records.record(occurrence, before, after, outcome, decision, detail, lastWords(occurrence));
        if (shadow != null) {
            shadow.ended(occurrence, before, after, outcome, decision, detail);
        }
    }

    /** The progress of the function that {@code occurrence} has left; empty if it left none. A stop leaves it, too. */
    private String lastWords(Occurrence occurrence) {
        return begun != null && isBegun(occurrence) && begun.number() == leavingNumber ? leaving : "";
    }

    /** Whether {@code occurrence} had its turn; others end at once, also while it is in progress. */
    private boolean isBegun(Occurrence occurrence) {
        return begun != null && begun.occurrence() == occurrence;
    }

    /** An event that neither model knows is logged once, and again only after a different one. */
    private void warnOfUnknown(Occurrence.Heard heard, Outcome outcome, String detail) {
        if (outcome == Outcome.HANDLED || knowledge.access().eventNames().knows(heard.event())) {
            unknown = null;
        } else if (!heard.event().equals(unknown)) {
            unknown = heard.event();
            records.failures().warnSoon(detail + " (" + heard.source().name().toLowerCase(Locale.ROOT) + ")");
        }
    }
}
