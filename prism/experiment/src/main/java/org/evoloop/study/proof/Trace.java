package org.evoloop.study.proof;

import java.util.List;
import java.util.Random;
import java.util.Set;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Work;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/** What the real core does on random inputs, in any order: a line for each input, and one for what it knows then. */
final class Trace {
    /** More than so many must not wait, and not so much may happen while a step is on its way, in the specification. */
    private static final int MOST = 9;

    private final EvolvingPair evolution;
    private final Random random;
    private final Core core;
    private final StringBuilder out = new StringBuilder("> ANEW 0 0 0 0\n");
    private boolean swapped;
    private long now = 1;
    private @Nullable Decision plan;

    private Trace(EvolvingPair evolution, long seed) {
        this.evolution = evolution;
        this.random = new Random(seed);
        this.core = new Core(evolution.rules(), output -> {});
    }

    static String random(EvolvingPair evolution, long seed, int length) {
        Trace trace = new Trace(evolution, seed);
        trace.writeState();
        for (int count = 0; count < length && trace.hasRoom(); count++) {
            trace.go();
        }
        return trace.out.toString();
    }

    private boolean hasRoom() {
        Snapshot snapshot = core.snapshot();
        boolean inWork = snapshot.work() == null || snapshot.work().meanwhile().size() < MOST;
        return inWork
                && snapshot.waiting().size() < MOST
                && (snapshot.doubt() == null || snapshot.doubt().meanwhile().size() < MOST);
    }

    private void writeState() {
        out.append(StateText.of(evolution, core.snapshot(), swapped)).append('\n');
    }

    private void apply(Input input, String name, long... arguments) {
        out.append("> ").append(name);
        for (int index = 0; index < 4; index++) {
            out.append(' ').append(index < arguments.length ? arguments[index] : 0);
        }
        out.append('\n');
        core.apply(input);
        now++;
        writeState();
    }

    private void go() {
        Work work = core.snapshot().work();
        if (random.nextInt(3) > 0 && work != null) {
            proceed(work);
        } else if (random.nextInt(3) > 0 && core.isOpen() && core.hasNext()) {
            apply(new Input.Ready(), "READY_FOR");
        } else if (random.nextInt(3) > 0) {
            occur();
        } else {
            operate();
        }
    }

    /** What the components do with the occurrence in progress. */
    private void proceed(Work work) {
        long number = work.pending().number();
        Decision decision = work.decision();
        int bad = random.nextInt(12);
        if (bad == 0) {
            apply(new Input.Failed(number, "it failed", now), "FAILED", number);
        } else if (bad == 1) {
            apply(new Input.GivenUp(number, "it was given up", now), "GIVEN_UP", number);
        } else if (bad == 2) {
            apply(new Input.Dismissed(number, now), "DISMISSED", number);
        } else if (work.stage() == Work.Stage.SENDING) {
            sent(number);
        } else if (decision instanceof Decision.Inquiry) {
            locate(number);
        } else if (decision == null || work.stage() == Work.Stage.RESUMED) {
            plan(work, number);
        } else {
            apply(new Input.Sending(number), "SENDING_IT", number);
        }
    }

    /** On what is so now, or on what was so before. */
    private void plan(Work work, long number) {
        if (plan == null || random.nextInt(4) > 0) {
            plan = evolution.rules(swapped).decide(core.at(), core.steps(), work.pending(), guard -> false);
        }
        apply(
                new Input.Planned(number, plan, now),
                "PLANNED",
                number,
                Codes.of(plan, evolution),
                evolution.number(plan.deviceStart(), true),
                evolution.number(plan.before().evolved(), false));
        if (random.nextBoolean()) {
            plan = null;
        }
    }

    private void sent(long number) {
        boolean inOrder = random.nextBoolean();
        apply(new Input.Sent(number, inOrder, now), "WAS_SENT", number, inOrder ? 1 : 0);
    }

    private void locate(long number) {
        State state = random.nextInt(4) == 0 ? null : any(evolution.deviceStates());
        apply(
                new Input.Located(number, state, now),
                "LOCATED",
                number,
                state == null ? 0 : evolution.number(state, true));
    }

    private <T> T any(List<T> members) {
        return members.get(random.nextInt(members.size()));
    }

    private void occur() {
        long visit = core.snapshot().visit().number() - random.nextInt(2);
        Event event = any(random.nextBoolean() ? evolution.events() : List.copyOf(evolution.sendable()));
        int number = evolution.number(event);
        int former = visit == core.snapshot().visit().number() ? 1 : 2;
        switch (random.nextInt(visit > 0 ? 6 : 3)) {
            case 0 -> heard(event, Source.CONTROLLER, false, Occurrence.ANY_VISIT, 1, 0);
            case 1 -> heard(event, Source.DEVICE, true, Occurrence.ANY_VISIT, 2, 0);
            case 2 -> found();
            case 3 -> heard(event, Source.FUNCTION, false, visit, 4, former);
            case 4 ->
                apply(
                        new Input.Observed(new Occurrence.Asked(event, Values.NONE, visit, now)),
                        "ASKED_OF",
                        number,
                        former);
            default -> timer();
        }
    }

    private void heard(Event event, Source source, boolean acted, long visit, int sourceNumber, int visitNumber) {
        Occurrence heard = new Occurrence.Heard(event, Values.NONE, source, acted, Set.of(), visit, now);
        apply(new Input.Observed(heard), "HEARD_OF", evolution.number(event), sourceNumber, visitNumber, acted ? 1 : 0);
    }

    private void found() {
        State state = any(evolution.deviceStates());
        boolean late = random.nextInt(4) == 0;
        long at = late ? core.snapshot().lastStepNanos() - 1 : now;
        apply(
                new Input.Observed(new Occurrence.Found(state, at)),
                "FOUND_AT",
                evolution.number(state, true),
                late ? 1 : 0);
    }

    private void timer() {
        Snapshot snapshot = core.snapshot();
        for (Event event : snapshot.visit().deadlines().keySet()) {
            long due = Math.max(now, snapshot.visit().deadlines().getOrDefault(event, now));
            apply(new Input.TimerDue(snapshot.visit().number(), event, due), "TIMER_DUE");
            now = due + 1;
        }
    }

    /** An action on the converter, or a report about a step that it no longer waits for. */
    private void operate() {
        switch (random.nextInt(10)) {
            case 0 -> apply(new Input.Closing(), "CLOSING");
            case 1 -> apply(new Input.Closed(), "CLOSED");
            case 2 -> apply(new Input.Recovered(now), "RECOVERED");
            case 3, 4 -> apply(new Input.Opened(now), "OPENED");
            case 5 -> apply(new Input.Changed(evolution.rules(swapped), now), "CHANGED");
            case 6 -> evolve();
            case 7 -> strayStep();
            default -> apply(new Input.Ready(), "READY_FOR");
        }
    }

    private void evolve() {
        boolean possible = core.hindrance(evolution.swap(swapped)).isEmpty();
        Input input = new Input.Evolved(evolution.swap(swapped), now);
        swapped ^= possible;
        plan = null;
        apply(input, "EVOLVED_TO");
    }

    private void strayStep() {
        Snapshot snapshot = core.snapshot();
        sent(snapshot.doubt() == null ? 1 + random.nextInt(3) : snapshot.doubt().number());
    }
}
