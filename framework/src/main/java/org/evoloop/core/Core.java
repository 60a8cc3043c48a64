package org.evoloop.core;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

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
    /** So often may the device overtake the plans for one occurrence. */
    static final int MOST_ATTEMPTS = 8;

    private static final String OVERTAKEN_FINDING = "the device has been sent an event since";
    private static final String FOUND_MEANWHILE = "the device was found meanwhile";

    private Rules rules;
    private boolean open;
    private final Place place;
    private final Line line;
    private final Stay stay;
    private final Counts counts;
    private @Nullable Work work;
    private boolean followOwed;
    private List<Output> out = new ArrayList<>();

    /** A converter that has not been opened yet, in the initial states of its models. */
    public Core(Rules rules) {
        this.rules = rules;
        this.place = new Place(rules.table().models().initial(), 0, 0, null);
        this.counts = new Counts();
        this.line = new Line(List.of(), counts, false);
        this.stay = new Stay();
    }

    /** Goes on where {@code snapshot} was taken, by the {@code rules} that counted then. */
    public Core(Rules rules, Snapshot snapshot) {
        Snapshot.Visit visit = snapshot.visit();
        this.rules = rules;
        this.open = snapshot.open();
        this.place = new Place(snapshot.at(), snapshot.steps(), snapshot.lastStepNanos(), snapshot.doubt());
        this.counts = new Counts(snapshot.tally());
        this.line = new Line(snapshot.waiting(), counts, snapshot.losing());
        this.stay = new Stay(visit.number(), visit.over(), visit.by(), visit.deadlines());
        this.work = snapshot.work();
        this.followOwed = snapshot.followOwed();
    }

    /** All that it knows now. */
    public Snapshot snapshot() {
        return new Snapshot(
                open,
                place.at(),
                place.lastDoubt(),
                place.steps(),
                place.lastStepNanos(),
                new Snapshot.Visit(stay.number(), stay.isOver(), stay.by(), stay.inOrder()),
                line.waiting(),
                line.isLosing(),
                followOwed,
                work,
                counts.tally());
    }

    /** Takes {@code input} and adds to {@code outputs} what follows from it, in order. */
    public void apply(Input input, List<Output> outputs) {
        out = outputs;
        if (input instanceof Input.Observed observed) {
            observe(observed.occurrence());
        } else if (input instanceof Input.Ready ready) {
            begin(ready.atNanos());
        } else if (input instanceof Input.Planned planned) {
            plan(planned);
        } else if (input instanceof Input.Sending sending) {
            send(sending);
        } else if (input instanceof Input.Sent sent) {
            took(sent);
        } else if (input instanceof Input.EffectRun run) {
            ran(run);
        } else if (input instanceof Input.TimerDue due) {
            timerDue(due);
        } else if (input instanceof Input.Located located) {
            located(located);
        } else if (input instanceof Input.Dismissed dismissed) {
            conclude(dismissed.number(), Outcome.IGNORED, "dismissed", 0);
        } else if (input instanceof Input.Failed failed) {
            conclude(failed.number(), Outcome.FAILED, failed.reason(), failed.atNanos());
        } else if (input instanceof Input.GivenUp givenUp) {
            giveUp(givenUp);
        } else if (input instanceof Input.Opened opened) {
            open(opened.atNanos());
        } else if (input instanceof Input.Closing) {
            close();
        } else if (input instanceof Input.Closed) {
            stay.leave(out);
        } else if (input instanceof Input.Changed changed) {
            change(changed);
        }
    }

    /** Where device and evolved system are. */
    public Configuration at() {
        return place.at();
    }

    /** How many steps have been sent and have had their effect. */
    public long steps() {
        return place.steps();
    }

    /** Why the record may be wrong; empty if it is sure. */
    public String doubt() {
        Doubt doubt = place.doubt();
        return doubt == null ? "" : doubt.why();
    }

    /** What it goes by. */
    public Rules rules() {
        return rules;
    }

    /** Whether the step that was asked for may be sent: it was announced, and nothing has overtaken it. */
    public boolean maySend(long number) {
        Work current = inProgress(number);
        return current != null && current.sending();
    }

    /** Whether an occurrence is in progress. */
    public boolean isBusy() {
        return work != null;
    }

    /** Whether one more event of a controller would be taken. */
    public boolean hasRoom() {
        return line.hasRoom(rules.queueCapacity(), work == null);
    }

    /** How many occurrences wait for their turn. */
    public int waiting() {
        return line.size();
    }

    /** How many occurrences came and what became of them. */
    public Tally tally() {
        return counts.tally();
    }

    // Observing

    private void observe(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Found found) {
            find(found);
        } else if (occurrence instanceof Occurrence.Heard heard
                && (heard.deviceActed()
                        || rules.table().isDevicesOwn(heard.event().trigger()))) {
            follow(heard);
        } else if (open) {
            enqueue(occurrence, null, null);
        } else {
            counts.observe();
            refuse(occurrence);
        }
    }

    private void refuse(Occurrence occurrence) {
        counts.refuse();
        out.add(new Output.Refused(occurrence));
    }

    /** The device has acted: the record follows at once, whatever waits or is on its way. */
    private void follow(Occurrence.Heard fact) {
        State from = place.at().original();
        Step own = rules.table().ownStep(from, fact.event(), fact.holding()::contains);
        happensMeanwhile(fact);
        if (own != null) {
            place.moveDevice(own.target(), out);
        }
        enqueue(fact, from, own);
    }

    /** What the device does while a step is on its way, or while it is asked where it is, may be older or newer than that. */
    private void happensMeanwhile(Occurrence fact) {
        Work current = work;
        if (current != null && (current.sending() || current.decision() instanceof Decision.Inquiry)) {
            work = current.acted(fact);
        }
        Doubt doubt = place.lastDoubt();
        if (doubt != null) {
            place.doubt(doubt.acted(fact));
        }
    }

    private void find(Occurrence.Found found) {
        if (!rules.table().models().original().hasState(found.state())) {
            endAtOnce(found, Outcome.FAILED, found.state() + " is not a state of the device's model");
        } else if (place.isOld(found)) {
            endAtOnce(found, Outcome.STALE, OVERTAKEN_FINDING);
        } else {
            happensMeanwhile(found);
            settleDoubt();
            goTo(found);
        }
    }

    private void goTo(Occurrence.Found found) {
        if (!place.isNoNews(found)) {
            State from = place.at().original();
            place.moveDevice(found.state(), out);
            enqueue(found, from, null);
        }
    }

    private void settleDoubt() {
        Doubt doubt = place.doubt();
        if (doubt != null) {
            place.doubt(doubt.settled(true));
            out.add(new Output.Doubted(""));
        }
    }

    private void endAtOnce(Occurrence occurrence, Outcome outcome, String detail) {
        counts.observe();
        ended(occurrence, place.at(), outcome, null, detail);
    }

    private void timerDue(Input.TimerDue due) {
        if (open && stay.isCurrent(due.visit()) && !stay.isOver() && stay.isDue(due.event(), due.atNanos())) {
            enqueue(
                    new Occurrence.Heard(due.event(), Values.NONE, Source.TIMER, due.visit(), due.atNanos()),
                    null,
                    null);
        }
    }

    private void enqueue(Occurrence occurrence, @Nullable State from, @Nullable Step own) {
        long number = counts.observe();
        boolean hasHappened = from != null || occurrence.isFact();
        boolean mayBeLost = !hasHappened && occurrence.source().isButton();
        int capacity = rules.queueCapacity();
        if (mayBeLost ? line.hasRoom(capacity, work == null) : line.hasRoomForFacts(capacity)) {
            line.add(new Pending(number, occurrence, from, own, place.steps(), 0));
            out.add(new Output.Queued(occurrence));
        } else {
            followOwed |= hasHappened;
            counts.end(Outcome.DROPPED);
            out.add(new Output.Dropped(occurrence, line.lose()));
        }
    }

    // Beginning

    private void begin(long atNanos) {
        while (work == null && open) {
            Pending next = line.next(occurrence -> false);
            if (next == null && followOwed) {
                next = owedFinding(atNanos);
            }
            if (next == null) {
                return;
            }
            giveTurn(next);
        }
    }

    /** In place of the facts that were lost: the new model is put where the device is. */
    private Pending owedFinding(long atNanos) {
        followOwed = false;
        State there = place.at().original();
        return new Pending(counts.observe(), new Occurrence.Found(there, atNanos), there, null, place.steps(), 0);
    }

    private void giveTurn(Pending pending) {
        Occurrence occurrence = pending.occurrence();
        if (occurrence.visit() != Occurrence.ANY_VISIT && !stay.isCurrent(occurrence.visit())) {
            ended(occurrence, place.at(), Outcome.STALE, null, "the state that raised it has been left");
            return;
        }
        if (occurrence instanceof Occurrence.InDoubt && place.doubt() == null) {
            ended(occurrence, place.at(), Outcome.HANDLED, null, FOUND_MEANWHILE);
            return;
        }
        if (occurrence instanceof Occurrence.Heard heard && heard.source() == Source.TIMER) {
            stay.heard(heard.event());
        }
        work = Work.begin(pending);
        out.add(new Output.Begin(pending));
    }

    // Carrying out

    private @Nullable Work inProgress(long number) {
        Work current = work;
        return current != null && current.pending().number() == number ? current : null;
    }

    private void plan(Input.Planned planned) {
        Work current = inProgress(planned.number());
        if (current == null || current.decision() != null) {
            return;
        }
        Decision decision = planned.decision();
        if (!decision.start().equals(place.at())) {
            again(current, "it was decided at " + decision.start(), planned.atNanos());
            return;
        }
        Pending pending = current.pending();
        out.add(new Output.Decided(
                pending, decision, planned.atNanos() - pending.occurrence().observedNanos()));
        if (decision.leavesState()) {
            // Before the first step leaves: a function that still moved the device would contradict it.
            stay.leave(out);
        }
        work = current.decided(decision);
        goOn(work, planned.atNanos());
    }

    private void goOn(Work current, long atNanos) {
        long number = current.pending().number();
        Step step = current.nextStep();
        String effect = current.nextEffect();
        if (current.decision() instanceof Decision.Inquiry) {
            out.add(new Output.Locate(number));
        } else if (step != null) {
            out.add(new Output.Send(number, step));
        } else if (effect != null) {
            out.add(new Output.Run(number, effect));
        } else {
            arrive(current, atNanos);
        }
    }

    private void send(Input.Sending sending) {
        Work current = inProgress(sending.number());
        Step step = current == null || current.sending() ? null : current.nextStep();
        if (current != null && step != null) {
            if (step.source().equals(place.at().original())) {
                work = current.sendingNext();
            } else {
                again(current, "the device left " + step.source() + " by itself", sending.atNanos());
            }
        }
    }

    private void took(Input.Sent sent) {
        Work current = inProgress(sent.number());
        Step step = current == null || !current.sending() ? null : current.nextStep();
        if (current == null || step == null) {
            tookLate(sent);
            return;
        }
        State target = step.target();
        boolean sure = true;
        if (!current.meanwhile().isEmpty()) {
            // In the order in which they were told, the step came last.
            target = Overlap.takes(rules.table(), place.at().original(), step);
            sure = sent.inOrder() || Overlap.alwaysEndsIn(target, rules.table(), step, current.meanwhile());
        }
        place.took(target, sent.atNanos(), out);
        out.add(new Output.Took(step));
        Work next = current.tookNext();
        work = next;
        if (!sure || !target.equals(step.target())) {
            again(next, "the device acted by itself while " + step.trigger() + " was sent", sent.atNanos());
        } else {
            goOn(next, sent.atNanos());
        }
        if (!sure) {
            doubt(
                    "nobody knows whether the device acted before or after it took " + step.trigger(),
                    current,
                    step,
                    sent.atNanos());
        }
    }

    /** A step that was given up has had its effect after all, which settles its doubt if the order is known. */
    private void tookLate(Input.Sent sent) {
        Doubt doubt = place.lastDoubt();
        if (doubt == null) {
            return;
        }
        State target = Overlap.takes(rules.table(), place.at().original(), doubt.step());
        Work current = work;
        boolean another = current != null && current.sending();
        if (doubt.number() == sent.number() && isOrderKnown(sent, doubt, target, another)) {
            settleDoubt();
            place.doubt(doubt.stepsBefore() == Doubt.UNSETTLED ? place.lastDoubt() : null);
            place.took(target, sent.atNanos(), out);
            out.add(new Output.Took(doubt.step()));
            if (current != null && another) {
                // To the step that is being sent, that is something which the device did before.
                work = current.acted(new Occurrence.Found(target, sent.atNanos()));
            }
        } else if (doubt.settled()) {
            place.doubt(doubt.settled(false));
            out.add(new Output.Doubted(doubt.why()));
            ask(doubt.why(), sent.atNanos());
        }
    }

    private boolean isOrderKnown(Input.Sent sent, Doubt doubt, State target, boolean another) {
        if (sent.inOrder()) {
            return doubt.settled() || doubt.stepsBefore() == place.steps();
        }
        return doubt.stepsBefore() == place.steps()
                && !another
                && Overlap.alwaysEndsIn(target, rules.table(), doubt.step(), doubt.meanwhile());
    }

    private void ran(Input.EffectRun run) {
        Work current = inProgress(run.number());
        if (current != null) {
            Work next = current.ranNext(run.failure());
            work = next;
            goOn(next, run.atNanos());
        }
    }

    /** All is done: the evolved system enters its next state. */
    private void arrive(Work current, long atNanos) {
        Decision decision = Objects.requireNonNull(current.decision());
        long visit = stay.number();
        place.move(place.at().withEvolved(decision.after().evolved()), out);
        if (decision.leavesState()) {
            Transition transition = decision.transition();
            enter(transition, transition == null ? Set.of() : transition.keeps(), atNanos);
        }
        work = null;
        ended(
                current.pending().occurrence(),
                decision.before(),
                outcome(current, decision),
                decision,
                current.failedEffects());
        if (decision instanceof Decision.Impossible) {
            // Its timers start anew: what was impossible now may be possible the next time.
            stay.leave(out);
        }
        enterAgain(atNanos);
        out.add(new Output.Settle(place.at()));
        if (stay.number() != visit) {
            begins();
        }
    }

    private static Outcome outcome(Work done, Decision decision) {
        if (decision instanceof Decision.NotAcceptable || decision instanceof Decision.Refused) {
            return Outcome.IGNORED;
        }
        return decision instanceof Decision.Impossible || !done.failedEffects().isEmpty()
                ? Outcome.FAILED
                : Outcome.HANDLED;
    }

    private void enter(@Nullable Transition by, Set<String> kept, long atNanos) {
        stay.enter(place.at().evolved(), by, kept, rules, atNanos, out);
    }

    /** Enters the current state anew if its visit has ended without another state being entered. */
    private void enterAgain(long atNanos) {
        if (stay.isOver() && open && !line.isRetryNext()) {
            enter(stay.by(), Set.of(), atNanos);
        }
    }

    /** The function of the state that was entered begins, if that is a new one. */
    private void begins() {
        if (rules.table().models().isNew(place.at().evolved())) {
            out.add(new Output.Start(stay.number()));
        }
    }

    private void ended(
            Occurrence occurrence, Configuration before, Outcome outcome, @Nullable Decision decision, String detail) {
        counts.end(outcome);
        out.add(new Output.Ended(occurrence, before, place.at(), outcome, decision, detail));
    }

    // What goes wrong

    /** The plan has been overtaken: the occurrence is decided anew, before all others. */
    private void again(Work current, String why, long atNanos) {
        Pending next = current.pending().again();
        Occurrence occurrence = next.occurrence();
        if (next.attempts() > MOST_ATTEMPTS || (!open && !next.hasHappened())) {
            conclude(next.number(), Outcome.FAILED, "overtaken: " + why, atNanos);
        } else {
            work = null;
            line.addFirst(next);
            out.add(new Output.Overtaken(occurrence, why));
        }
    }

    /** The occurrence in progress ends before its plan was carried out. */
    private void conclude(long number, Outcome outcome, String reason, long atNanos) {
        Work current = inProgress(number);
        if (current == null) {
            return;
        }
        Pending pending = current.pending();
        Decision decision = current.decision();
        State from = pending.from();
        Configuration before = decision != null
                ? decision.before()
                : from == null ? place.at() : place.at().withOriginal(from);
        long visit = stay.number();
        work = null;
        ended(pending.occurrence(), before, outcome, null, reason);
        enterAgain(atNanos);
        if (stay.number() != visit) {
            begins();
        }
    }

    private void giveUp(Input.GivenUp givenUp) {
        Work current = inProgress(givenUp.number());
        Step step = current == null || !current.sending() ? null : current.nextStep();
        conclude(givenUp.number(), Outcome.FAILED, givenUp.reason(), givenUp.atNanos());
        if (current != null && step != null) {
            doubt(
                    "nobody knows whether " + step.trigger() + " had its effect: " + givenUp.reason(),
                    current,
                    step,
                    givenUp.atNanos());
        }
    }

    // Doubt

    /** From now on the record is in doubt; the device is asked before anything else is begun. */
    private void doubt(String why, Work during, Step step, long atNanos) {
        long before = place.lastDoubt() == null ? place.steps() : Doubt.UNSETTLED;
        place.doubt(new Doubt(why, during.pending().number(), step, before, during.meanwhile(), false));
        out.add(new Output.Doubted(why));
        ask(why, atNanos);
    }

    private void ask(String why, long atNanos) {
        line.addFirst(
                new Pending(counts.observe(), new Occurrence.InDoubt(why, atNanos), null, null, place.steps(), 0));
    }

    private void located(Input.Located located) {
        Work current = inProgress(located.number());
        if (current == null) {
            return;
        }
        // What the device has done since it was asked may be older or newer than its answer.
        boolean overtaken = place.doubt() != null && !current.meanwhile().isEmpty();
        if (overtaken && current.pending().attempts() < MOST_ATTEMPTS) {
            work = current.askingAgain();
            out.add(new Output.Locate(located.number()));
            return;
        }
        State state = located.state();
        State taken = place.at().original();
        if (place.doubt() == null) {
            conclude(located.number(), Outcome.HANDLED, FOUND_MEANWHILE, located.atNanos());
        } else if (overtaken
                || state == null
                || !rules.table().models().original().hasState(state)) {
            conclude(
                    located.number(),
                    Outcome.IGNORED,
                    "the device cannot tell where it is; it is taken to be in " + taken,
                    located.atNanos());
        } else if (state.equals(taken)) {
            happensMeanwhile(new Occurrence.Found(state, located.atNanos()));
            settleDoubt();
            conclude(located.number(), Outcome.HANDLED, "the device is in " + state, located.atNanos());
        } else {
            happensMeanwhile(new Occurrence.Found(state, located.atNanos()));
            settleDoubt();
            Decision found = rules.table().find(place.at(), state);
            place.moveDevice(state, out);
            if (found.leavesState()) {
                stay.leave(out);
            }
            arrive(current.decided(found), located.atNanos());
        }
    }

    // Opening, closing and changing

    /** Another component may be able to tell what the one before it could not. */
    private void change(Input.Changed changed) {
        rules = changed.rules();
        Doubt doubt = place.doubt();
        if (doubt != null && !line.holdsDoubt()) {
            ask(doubt.why(), changed.atNanos());
        }
    }

    private void open(long atNanos) {
        open = true;
        Doubt doubt = place.doubt();
        if (doubt != null && !line.holdsDoubt()) {
            ask(doubt.why(), atNanos);
        }
        stay.leave(out);
        enter(stay.by(), Set.of(), atNanos);
        begins();
    }

    /** What has happened already waits until the converter is opened again; all else is refused. */
    private void close() {
        open = false;
        for (Pending pending : line.withoutFacts()) {
            refuse(pending.occurrence());
        }
    }
}
