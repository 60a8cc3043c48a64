package org.evoloop.engine;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** What must hold after every input of the core, and after everything that happens without its notice. */
final class Invariants {
    private final Snapshot before;
    private final @Nullable Input input;
    private final List<Output> said;
    private final Snapshot after;
    private final World world;

    private Invariants(Snapshot before, @Nullable Input input, List<Output> said, Snapshot after, World world) {
        this.before = before;
        this.input = input;
        this.said = said;
        this.after = after;
        this.world = world;
    }

    /** Which invariant is violated, and how; empty if none is. */
    static String check(Snapshot before, @Nullable Input input, List<Output> said, Snapshot after, World world) {
        Invariants invariants = new Invariants(before, input, said, after, world);
        return List.of(
                        invariants.recordIsDevice(),
                        invariants.whatTheDeviceObeyedIsDone(),
                        invariants.oneAfterTheOther(),
                        invariants.whatIsUrgentComesFirst(),
                        invariants.factsAreHeardFirst(),
                        invariants.theDeviceIsAskedFirst(),
                        invariants.sumIsRight(),
                        invariants.visitsEnd(),
                        invariants.stepsAreSentOnce(),
                        invariants.nothingIsStuck(),
                        invariants.nothingIsDoneAgain(),
                        invariants.factsAreKept(),
                        invariants.contradictionsAreNoticed(),
                        invariants.pressesHaveAnAge(),
                        invariants.controllersHaveTheirPlaces(),
                        invariants.theSystemFollowsTheDevice(),
                        invariants.functionsRun(),
                        invariants.noFunctionRunsWhileOtherModelsSettle())
                .stream()
                .filter(problem -> !problem.isEmpty())
                .findFirst()
                .orElseGet(() -> DeviceStateInvariants.check(before, input, said, after, world));
    }

    private String recordIsDevice() {
        boolean quiet = world.unreported.isEmpty() && !isInDoubt(after) && !world.misled;
        return quiet && !after.at().original().equals(world.device)
                ? "record: the device is in " + world.device + ", the record says " + after.at()
                : "";
    }

    /**
     * First come, first served, but for what is deferred, and only when nothing is in progress; what the device did by
     * itself comes before what is only asked for.
     */
    private String oneAfterTheOther() {
        for (Output output : said) {
            if (output instanceof Output.Begin begin) {
                if (before.work() != null && !isIn(before.work(), Work.Stage.INTERRUPTED)) {
                    return "order: " + begin + " while " + before.work() + " is in progress";
                }
                if (isDeferred(begin.pending().occurrence(), before)) {
                    return "order: " + begin + ", which " + before.at() + " defers";
                }
                int place = before.waiting().indexOf(begin.pending());
                if (place < 0) {
                    continue;
                }
                List<Pending> ahead = new ArrayList<>(before.waiting());
                ahead.retainAll(after.waiting());
                ahead.removeIf(this::isDeferred);
                if (begin.pending().goesFirst()) {
                    ahead.removeIf(pending -> !pending.goesFirst());
                } else if (isUrgent(begin.pending())) {
                    ahead.removeIf(pending -> !pending.goesFirst() && !isUrgent(pending));
                } else if (ahead.stream().anyMatch(Pending::goesFirst)) {
                    return "order: " + begin + " before the facts of " + ahead;
                }
                if (!ahead.isEmpty() && before.waiting().indexOf(ahead.get(0)) < place) {
                    return "order: " + begin + " before " + ahead.get(0);
                }
            }
        }
        return "";
    }

    /**
     * What is urgent is never lost; no other request is begun or decided before it, and no step of any other plan is sent
     * while it waits and the new model would take it.
     */
    private String whatIsUrgentComesFirst() {
        List<Pending> urgent = before.waiting().stream()
                .filter(pending -> isUrgent(pending)
                        && after.waiting().contains(pending)
                        && !isDeferred(pending)
                        && (pending.occurrence().visit() == Occurrence.ANY_VISIT
                                || pending.occurrence().visit()
                                        == before.visit().number()))
                .toList();
        boolean taken = urgent.stream()
                .anyMatch(pending -> world.rules()
                        .table()
                        .models()
                        .evolved()
                        .hasTrigger(before.at().evolved(), ((Occurrence.Heard) pending.occurrence()).event()));
        for (Output output : said) {
            if (output instanceof Output.Dropped dropped && isUrgent(dropped.occurrence())) {
                return "urgent: " + output;
            } else if (output instanceof Output.Begin begin && isBehind(begin.pending(), urgent)) {
                return "urgent: " + begin + " before " + urgent;
            } else if (output instanceof Output.Decided decided && taken && isBehind(decided.pending(), urgent)) {
                return "urgent: " + decided + " before " + urgent;
            }
        }
        boolean sends =
                input instanceof Input.Sending && after.work() != null && isIn(after.work(), Work.Stage.SENDING);
        return taken && sends && !isUrgent(after.work().pending()) ? "urgent: a step is sent before " + urgent : "";
    }

    private boolean isBehind(Pending pending, List<Pending> urgent) {
        return !urgent.isEmpty()
                && !pending.goesFirst()
                && !isUrgent(pending)
                && !isIn(before.work(), Work.Stage.INTERRUPTED);
    }

    private boolean isUrgent(Pending pending) {
        return world.rules().isUrgent(pending);
    }

    private boolean isUrgent(Occurrence occurrence) {
        return isUrgent(new Pending(0, occurrence, null, null, 0, 0));
    }

    /** The new model has heard of all that the device did by itself when it decides on a request. */
    private String factsAreHeardFirst() {
        for (Output output : said) {
            if (output instanceof Output.Decided decided
                    && !decided.pending().goesFirst()
                    && before.waiting().stream().anyMatch(Pending::hasHappened)) {
                return "unheard: " + decided + " before the facts of " + before.waiting();
            }
        }
        return "";
    }

    /** A record in doubt is not decided from before the device has been asked. */
    private String theDeviceIsAskedFirst() {
        boolean waits = isInDoubt(after)
                && after.waiting().stream().anyMatch(pending -> pending.occurrence() instanceof Occurrence.InDoubt);
        for (Output output : said) {
            if (waits
                    && output instanceof Output.Begin begin
                    && !(begin.pending().occurrence() instanceof Occurrence.InDoubt)
                    && !isIn(before.work(), Work.Stage.INTERRUPTED)) {
                return "question: " + begin + " before the device is asked";
            }
        }
        return "";
    }

    static boolean isInDoubt(Snapshot snapshot) {
        Doubt doubt = snapshot.doubt();
        return doubt != null && !doubt.settled();
    }

    private String sumIsRight() {
        Tally tally = after.tally();
        long sum = tally.handled()
                + tally.ignored()
                + tally.stale()
                + tally.failed()
                + tally.dropped()
                + tally.refused()
                + after.waiting().size()
                + (after.work() == null ? 0 : 1);
        Set<Long> numbers = new HashSet<>();
        boolean twice =
                after.work() != null && !numbers.add(after.work().pending().number());
        for (Pending pending : after.waiting()) {
            twice |= !numbers.add(pending.number());
        }
        return sum != tally.observed() || twice ? "sum: " + sum + " instead of what was observed, " + tally : "";
    }

    private String visitsEnd() {
        long visit = before.visit().number();
        boolean over = before.visit().over();
        for (Output output : said) {
            if (output instanceof Output.Begin begin) {
                Occurrence begun = begin.pending().occurrence();
                if (begun.visit() != Occurrence.ANY_VISIT && begun.visit() != visit) {
                    return "visit: " + begun + " of visit " + begun.visit() + " is begun in visit " + visit;
                }
            } else if (output instanceof Output.Leave) {
                if (over) {
                    return "visit: " + visit + " is left, which is over";
                }
                over = true;
            } else if (output instanceof Output.Enter enter) {
                if (!over
                        || enter.visit() != visit + 1
                        || !enter.state().equals(after.at().evolved())) {
                    return "visit: " + enter + " after visit " + visit + (over ? "" : ", which is not over");
                }
                over = false;
                visit++;
            } else if (output instanceof Output.Start start && start.visit() != visit) {
                return "visit: " + start + " in visit " + visit;
            }
        }
        return visit != after.visit().number() || over != after.visit().over()
                ? "visit: notified of " + visit + (over ? ", over" : "") + ", known " + after.visit()
                : "";
    }

    private String stepsAreSentOnce() {
        List<Output.Send> sends = new ArrayList<>();
        for (Output output : said) {
            if (output instanceof Output.Send send) {
                sends.add(send);
            }
        }
        boolean due = input instanceof Input.Planned || input instanceof Input.Sent;
        if (sends.size() > (due ? 1 : 0)) {
            return "sent: " + sends + " on " + input;
        }
        Work work = after.work();
        Step step = work == null || !work.sending() ? null : Snapshots.nextStep(work);
        if (input instanceof Input.Sending
                && step != null
                && !step.source().equals(after.at().original())) {
            return "sent: " + step + " with the device in " + after.at().original();
        }
        Work last = before.work();
        boolean sentNow = input instanceof Input.Sending && work != null && work.sending();
        return sentNow && last != null && last.sending() ? "sent: " + step + " a second time" : "";
    }

    private String nothingIsStuck() {
        Work work = after.work();
        boolean isToGoOn = isIn(work, Work.Stage.INTERRUPTED, Work.Stage.RESUMED);
        if (work != null && work.decision() != null && !work.sending() && !isToGoOn && world.asked == null) {
            return "stuck: nobody has to do anything for " + work;
        }
        boolean drained = after.waiting().isEmpty() && work == null && !after.followOwed();
        if (after.open() && drained && after.visit().over()) {
            return "stuck: visit " + after.visit().number() + " is over and no other has begun";
        }
        boolean waits = after.waiting().stream().anyMatch(pending -> !isDeferred(pending));
        return input instanceof Input.Ready
                        && (waits || work != null)
                        && (work == null || isIn(work, Work.Stage.INTERRUPTED))
                ? "stuck: nothing is begun"
                : "";
    }

    private static boolean isIn(@Nullable Work work, Work.Stage... stages) {
        return work != null && List.of(stages).contains(work.stage());
    }

    /** However a process ends, steps of a plan that were done stay done. */
    private String nothingIsDoneAgain() {
        Work last = before.work();
        Work work = after.work();
        if (!(input instanceof Input.Recovered) || last == null || last.decision() == null) {
            return "";
        }
        boolean kept = work == null
                ? last.sending()
                : last.decision().equals(work.decision())
                        && work.taken() == last.taken()
                        && work.effectsRun() >= last.effectsRun();
        return kept ? "" : "again: after " + last + " comes " + work;
    }

    /** The device cannot have done what its model does not have in its recorded state, so that is wrong. */
    private String contradictionsAreNoticed() {
        return input instanceof Input.Observed observed
                        && observed.occurrence() instanceof Occurrence.Heard fact
                        && isFact(fact)
                        && (before.work() == null || !before.work().sending())
                        && world.rules().table().isImpossible(before.at().original(), fact.event())
                        && !isInDoubt(after)
                ? "contradiction: " + fact + " in " + before.at() + " leaves no doubt"
                : "";
    }

    /** A press that is too old is not begun, and only such a press is stale. */
    private String pressesHaveAnAge() {
        for (Output output : said) {
            if (output instanceof Output.Begin begin
                    && isTooOld(begin.pending().occurrence())
                    && begin.pending().broken() == null
                    && (before.work() == null || Snapshots.nextStep(before.work()) != null)) {
                return "age: " + begin + " at " + after.nowNanos();
            }
            if (output instanceof Output.Ended ended
                    && ended.outcome() == Outcome.STALE
                    && isControllers(ended.occurrence())
                    && !isTooOld(ended.occurrence())) {
                return "age: " + ended + " at " + after.nowNanos();
            }
        }
        return "";
    }

    private boolean isTooOld(Occurrence occurrence) {
        return isControllers(occurrence)
                && after.nowNanos() - occurrence.observedNanos()
                        > world.rules().pressAge().toNanos()
                && !world.rules().table().mayDefer(((Occurrence.Heard) occurrence).event());
    }

    private String factsAreKept() {
        for (Output output : said) {
            Occurrence lost = output instanceof Output.Dropped dropped
                    ? dropped.occurrence()
                    : output instanceof Output.Refused refused ? refused.occurrence() : null;
            if (lost != null && isFact(lost)) {
                return "fact: " + output;
            }
        }
        return "";
    }

    /**
     * A controller's event is lost exactly if as many of those wait as there is room for, whatever else waits. What the
     * present state defers, what is urgent, and the others, have places of their own.
     */
    private String controllersHaveTheirPlaces() {
        int capacity = world.rules().queueCapacity();
        int places = Math.max(capacity, before.work() == null ? 1 : 0);
        for (Output output : said) {
            if (output instanceof Output.Dropped dropped && hasRoom(dropped.occurrence(), places)) {
                return "room: " + output + ", while there wait " + before.waiting();
            }
            if (output instanceof Output.Queued queued
                    && isControllers(queued.occurrence())
                    && !isUrgent(queued.occurrence())
                    && !hasRoom(queued.occurrence(), places)) {
                return "room: " + output + ", while there wait " + before.waiting();
            }
        }
        return "";
    }

    private boolean hasRoom(Occurrence occurrence, int places) {
        List<Pending> controllers = before.waiting().stream()
                .filter(pending -> pending.mayBeLost() && !isUrgent(pending))
                .toList();
        boolean waits = isDeferred(occurrence, before);
        return controllers.size() < places
                || controllers.stream()
                                .filter(pending -> isDeferred(pending.occurrence(), before) == waits)
                                .count()
                        < places;
    }

    private boolean isDeferred(Pending pending) {
        return isDeferred(pending.occurrence(), before) && isDeferred(pending.occurrence(), after);
    }

    private boolean isDeferred(Occurrence occurrence, Snapshot when) {
        return occurrence instanceof Occurrence.Heard heard
                && !isFact(heard)
                && world.rules().table().defers(when.at(), heard.event());
    }

    /** When nothing is left to be done, device and system are where they can be together, unless something failed. */
    private String theSystemFollowsTheDevice() {
        boolean quiet = after.open()
                && after.work() == null
                && !after.followOwed()
                && after.waiting().stream().allMatch(this::isDeferred)
                && !isInDoubt(after);
        return quiet && !world.mayBeApart && !world.isTogether(after.at())
                ? "apart: nothing leads to " + after.at()
                : "";
    }

    /** Whenever nothing is left to be done in a new state, its function has been started in this visit. */
    private String functionsRun() {
        boolean quiet = after.open() && after.work() == null && !after.visit().over();
        return quiet
                        && !after.followOwed()
                        && !(after.visit().startOwed()
                                && (isInDoubt(after) || !after.waiting().isEmpty()))
                        && world.rules().table().isNew(after.at().evolved())
                        && world.functionOf != after.visit().number()
                ? "function: that of " + after.at().evolved() + " does not run in " + after.visit()
                : "";
    }

    /** No function runs while the device may be sent to where the new model is; a closed converter sends nothing. */
    private String noFunctionRunsWhileOtherModelsSettle() {
        Work work = after.work();
        boolean settling = Snapshots.isOfOtherModels(work)
                || after.waiting().stream().anyMatch(pending -> pending.occurrence() instanceof Occurrence.Evolved);
        return settling && after.open() && !after.visit().over() ? "settling: meanwhile there is " + after.visit() : "";
    }

    /** If the device has obeyed, the transition is taken, whatever happens to the rest of the plan. */
    private String whatTheDeviceObeyedIsDone() {
        Work last = before.work();
        Decision decision = last == null ? null : last.decision();
        boolean brokenOff =
                input instanceof Input.Failed || input instanceof Input.GivenUp || input instanceof Input.Dismissed;
        return brokenOff
                        && decision != null
                        && last.taken() == decision.steps().size()
                        && last.effectsRun() < decision.effects().size()
                        && !after.at().evolved().equals(decision.after().evolved())
                ? "obeyed: after " + last + " the system is in " + after.at()
                : "";
    }

    private boolean isControllers(Occurrence occurrence) {
        return occurrence.source().isButton() && !isFact(occurrence);
    }

    private boolean isFact(Occurrence occurrence) {
        return occurrence.isFact() || (occurrence instanceof Occurrence.Heard heard && isDevicesOwn(heard.event()));
    }

    private boolean isDevicesOwn(Event event) {
        return world.rules().table().isDevicesOwn(event);
    }
}
