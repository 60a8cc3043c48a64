package org.evoloop.core;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.Configuration;

/**
 * A converter between its inputs and its outputs.
 *
 * <p>Occurrences wait in one line and are dealt with one at a time: begun, decided, carried out step by step, ended. Facts
 * come first: what the device did by itself moves the record when it is observed; only the new model's reaction waits for
 * its turn, and is decided from wherever the record is by then. A plan that a fact has overtaken is decided anew, so that
 * nothing is ever sent from a place where the device no longer is.
 *
 * <p>Threading: not thread-safe; whoever drives it gives it one input after the other.
 */
public final class Core {
    private final Ledger ledger;
    private final Arrivals arrivals;
    private final Conversion conversion;

    /** A converter that has not been opened yet, in the initial states of its models. */
    public Core(Rules rules) {
        this(rules, fresh(rules));
    }

    /** Goes on where {@code snapshot} was taken, by the {@code rules} that counted then. */
    public Core(Rules rules, Snapshot snapshot) {
        this.ledger = new Ledger(rules, snapshot);
        this.arrivals = new Arrivals(ledger);
        this.conversion = new Conversion(ledger);
    }

    private static Snapshot fresh(Rules rules) {
        return new Snapshot(
                false,
                rules.table().models().initial(),
                null,
                0,
                0,
                new Snapshot.Visit(0, true, null, Map.of()),
                List.of(),
                false,
                false,
                null,
                new Tally(0, 0, 0, 0, 0, 0, 0, 0, 0));
    }

    /** All that it knows now. */
    public Snapshot snapshot() {
        return ledger.snapshot();
    }

    /** Takes {@code input} and adds to {@code outputs} what follows from it, in order. */
    public void apply(Input input, List<Output> outputs) {
        ledger.out = outputs;
        if (input instanceof Input.Observed observed) {
            arrivals.observe(observed.occurrence());
        } else if (input instanceof Input.Ready ready) {
            arrivals.begin(ready.atNanos());
        } else if (input instanceof Input.Planned planned) {
            conversion.plan(planned);
        } else if (input instanceof Input.Sending sending) {
            conversion.send(sending);
        } else if (input instanceof Input.Sent sent) {
            conversion.took(sent);
        } else if (input instanceof Input.EffectRun run) {
            conversion.ran(run);
        } else if (input instanceof Input.TimerDue due) {
            arrivals.timerDue(due);
        } else if (input instanceof Input.Located located) {
            conversion.located(located);
        } else if (input instanceof Input.Dismissed dismissed) {
            conversion.conclude(dismissed.number(), Outcome.IGNORED, "dismissed", dismissed.atNanos());
        } else if (input instanceof Input.Failed failed) {
            conversion.conclude(failed.number(), Outcome.FAILED, failed.reason(), failed.atNanos());
        } else if (input instanceof Input.GivenUp givenUp) {
            conversion.giveUp(givenUp);
        } else if (input instanceof Input.Opened opened) {
            open(opened.atNanos());
        } else if (input instanceof Input.Closing) {
            close();
        } else if (input instanceof Input.Closed) {
            ledger.stay.leave(outputs);
        } else if (input instanceof Input.Changed changed) {
            ledger.rules = changed.rules();
            // Another component may be able to tell what the one before it could not.
            ledger.ask(changed.atNanos());
        }
    }

    private void open(long atNanos) {
        long visit = ledger.stay.number();
        ledger.open = true;
        ledger.ask(atNanos);
        ledger.stay.leave(ledger.out);
        ledger.enter(ledger.stay.by(), Set.of(), atNanos);
        ledger.start(visit);
    }

    /** What has happened already waits until the converter is opened again; all else is refused. */
    private void close() {
        ledger.open = false;
        for (Pending pending : ledger.line.withoutFacts()) {
            ledger.refused(pending.occurrence());
        }
    }

    /** Where device and evolved system are. */
    public Configuration at() {
        return ledger.place.at();
    }

    /** How many steps have been sent and have had their effect. */
    public long steps() {
        return ledger.place.steps();
    }

    /** Why the record may be wrong; empty if it is sure. */
    public String doubt() {
        Doubt doubt = ledger.place.doubt();
        return doubt == null ? "" : doubt.why();
    }

    /** What it goes by. */
    public Rules rules() {
        return ledger.rules;
    }

    /** Whether the step that was asked for may be sent: it was announced, and nothing has overtaken it. */
    public boolean maySend(long number) {
        Work current = ledger.inProgress(number);
        return current != null && current.sending();
    }

    /** Whether an occurrence is in progress. */
    public boolean isBusy() {
        return ledger.work != null;
    }

    /** Whether one more event of a controller would be taken. */
    public boolean hasRoom() {
        return ledger.line.hasRoom(ledger.rules.queueCapacity(), ledger.work == null);
    }

    /** How many occurrences wait for their turn. */
    public int waiting() {
        return ledger.line.size();
    }

    /** How many occurrences came and what became of them. */
    public Tally tally() {
        return ledger.counts.tally();
    }
}
