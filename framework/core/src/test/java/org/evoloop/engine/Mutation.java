package org.evoloop.engine;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.evoloop.engine.Scene.Act;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;

/**
 * Mechanisms of the core, each removed by undoing its changes to a snapshot or its outputs, and the invariant that must
 * fail without it.
 */
enum Mutation implements Removal {
    FACTS_WAIT_FOR_THEIR_TURN("record", Scene.robot().with(1, Act.OWN)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return isFact(input) ? Snapshots.at(after, before.at()) : after;
        }
    },
    CLOSING_DISCARDS_FACTS("sum", Scene.robot().with(1, Act.OWN, Act.STOP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Closing ? Snapshots.waiting(after, List.of()) : after;
        }
    },
    A_CLOSED_CONVERTER_HEARS_NO_FACTS("record", Scene.robot().with(1, Act.OWN)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return isFact(input) && !before.open() ? before : after;
        }
    },
    FACTS_ARE_REFUSED_LIKE_PRESSES("fact", Scene.bulb().with(1, Act.OWN)) {
        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return isFact(input) ? List.of(new Output.Refused(((Input.Observed) input).occurrence())) : said;
        }
    },
    GIVING_UP_LEAVES_NO_DOUBT("record", Scene.bulb().with(1, Act.PRESS, Act.GIVE_UP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.GivenUp ? Snapshots.sure(after) : after;
        }
    },
    THE_ORDER_IS_NEVER_IN_DOUBT("record", Scene.robot().outOfOrder().with(1, Act.PRESS, Act.JUMP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Sent && before.doubt() == null ? Snapshots.sure(after) : after;
        }
    },
    GUARDS_LET_EVERY_STEP_BE_TAKEN("record", Scene.lamp().with(1, Act.PRESS).with(3, Act.OWN)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            // In order, only guards make it uncertain where a step has taken the device.
            return input instanceof Input.Sent sent && sent.inOrder() && before.doubt() == null
                    ? Snapshots.sure(after)
                    : after;
        }
    },
    THE_GUARDS_OF_AN_EARLIER_FACT_COUNT("record", Scene.lamp().with(2, Act.OWN)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            if (!isFact(input) || before.waiting().isEmpty()) {
                return after;
            }
            Occurrence.Heard earlier =
                    (Occurrence.Heard) before.waiting().get(0).occurrence();
            Occurrence.Heard now = (Occurrence.Heard) ((Input.Observed) input).occurrence();
            State from = before.at().original();
            Step own = scene().rules().table().ownStep(from, now.event(), earlier.holding()::contains);
            return Snapshots.at(after, after.at().withOriginal(own == null ? from : own.target()));
        }
    },
    A_FACT_CHANGES_NOTHING_THAT_THE_DEVICE_REMEMBERS("record", Scene.lamp().with(3, Act.OWN)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            State there = after.at().original();
            State forgetful =
                    scene().rules().table().models().original().alike(there).get(0);
            return isFact(input) ? Snapshots.at(after, after.at().withOriginal(forgetful)) : after;
        }
    },
    WHAT_HAPPENS_DURING_A_STEP_IS_FORGOTTEN("record", Scene.bulb().with(1, Act.PRESS, Act.OWN)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return isFact(input) ? Snapshots.work(after, before.work()) : after;
        }
    },
    AN_ANSWER_COUNTS_HOWEVER_OLD_IT_IS("record", Scene.bulb().with(1, Act.PRESS, Act.GIVE_UP, Act.OWN)) {
        @Override
        public Snapshot ahead(Snapshot before, Input input) {
            Work work = before.work();
            return input instanceof Input.Located && work != null
                    ? Snapshots.work(before, Snapshots.asking(work.pending(), before))
                    : before;
        }
    },
    AN_OVERTAKEN_STEP_IS_SENT_ALL_THE_SAME("sent", Scene.bulb().with(1, Act.PRESS, Act.OWN)) {
        @Override
        public Snapshot ahead(Snapshot before, Input input) {
            Work work = before.work();
            Step step = work == null ? null : Snapshots.nextStep(work);
            return input instanceof Input.Sending && step != null
                    ? Snapshots.at(before, before.at().withOriginal(step.source()))
                    : before;
        }

        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Sending
                    ? Snapshots.at(after, after.at().withOriginal(before.at().original()))
                    : after;
        }
    },
    OTHER_MODELS_FORGET_WHAT_WAITS("sum", Scene.dancingRobot().with(1, Act.PRESS, Act.EVOLVE)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Evolved ? Snapshots.waiting(after, List.of()) : after;
        }
    },
    OTHER_MODELS_BEGIN_WHERE_THEY_WOULD_INITIALLY("record", Scene.dancingRobot().with(1, Act.OWN, Act.EVOLVE)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Evolved evolved
                    ? Snapshots.at(
                            after, evolved.swap().rules().table().models().initial())
                    : after;
        }
    },
    OTHER_MODELS_TAKE_OVER_AS_IF_DEVICE_AND_SYSTEM_STOOD_TOGETHER(
            "stuck", Scene.busyRobot().with(2, Act.PRESS).with(1, Act.EVOLVE)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Evolved
                    ? Snapshots.waiting(
                            Snapshots.tally(after, before.tally()),
                            after.waiting().stream()
                                    .filter(pending -> !(pending.occurrence() instanceof Occurrence.Evolved))
                                    .toList())
                    : after;
        }
    },
    A_STATE_IS_ENTERED_WHILE_OTHER_MODELS_SETTLE(
            "settling", Scene.busyRobot().with(2, Act.PRESS).with(1, Act.EVOLVE, Act.STOP)) {
        @Override
        public List<Pending> hidden(Snapshot before, Input input) {
            return input instanceof Input.Opened ? before.waiting() : List.of();
        }
    },
    THE_QUEUE_DOES_NOT_WAIT("order", Scene.bulb().with(2, Act.PRESS)) {
        @Override
        public Snapshot ahead(Snapshot before, Input input) {
            return input instanceof Input.Ready ? Snapshots.work(before, null) : before;
        }
    },
    LAST_COME_IS_FIRST_SERVED("order", Scene.bulb().with(2, Act.PRESS)) {
        @Override
        public Snapshot ahead(Snapshot before, Input input) {
            List<Pending> reversed = new ArrayList<>(before.waiting());
            Collections.reverse(reversed);
            return input instanceof Input.Ready ? Snapshots.waiting(before, reversed) : before;
        }
    },
    FACTS_WAIT_BEHIND_REQUESTS("order", Scene.robot().with(1, Act.PRESS, Act.OWN)) {
        @Override
        public List<Pending> hidden(Snapshot before, Input input) {
            List<Pending> waiting = before.waiting();
            return input instanceof Input.Ready
                            && !waiting.isEmpty()
                            && !waiting.get(0).goesFirst()
                    ? waiting.subList(1, waiting.size())
                    : List.of();
        }
    },
    A_REQUEST_THAT_HAS_BEGUN_IS_DECIDED_BEFORE_FACTS("unheard", Scene.robot().with(1, Act.PRESS, Act.OWN)) {
        @Override
        public List<Pending> hidden(Snapshot before, Input input) {
            return input instanceof Input.Planned ? before.waiting() : List.of();
        }
    },
    WHAT_IS_URGENT_HAS_NO_PLACE_OF_ITS_OWN("urgent", Scene.lift().with(2, Act.PRESS)) {
        @Override
        public boolean isLost(Snapshot before, Input input) {
            return isLostInAFullQueue(before, input);
        }
    },
    WHAT_IS_URGENT_WAITS_FOR_ITS_TURN("urgent", Scene.lift().with(2, Act.PRESS)) {
        @Override
        public List<Pending> hidden(Snapshot before, Input input) {
            List<Pending> waiting = before.waiting();
            return input instanceof Input.Ready && waiting.size() > 1 ? waiting.subList(1, waiting.size()) : List.of();
        }
    },
    A_REQUEST_THAT_HAS_BEGUN_IS_DECIDED_BEFORE_WHAT_IS_URGENT(
            "urgent", Scene.lift().with(2, Act.PRESS)) {
        @Override
        public List<Pending> hidden(Snapshot before, Input input) {
            return input instanceof Input.Planned ? before.waiting() : List.of();
        }
    },
    A_PLAN_GOES_ON_WHILE_WHAT_IS_URGENT_WAITS("urgent", Scene.lift().with(2, Act.PRESS)) {
        @Override
        public List<Pending> hidden(Snapshot before, Input input) {
            return input instanceof Input.Sending ? before.waiting() : List.of();
        }
    },
    A_STEP_IS_ASKED_FOR_TWICE("sent", Scene.bulb().with(1, Act.PRESS)) {
        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return said.stream()
                    .flatMap(output ->
                            output instanceof Output.Send ? List.of(output, output).stream() : List.of(output).stream())
                    .toList();
        }
    },
    A_STEP_THAT_WAS_TAKEN_IS_STILL_TO_BE_TAKEN("record", Scene.bulb().with(1, Act.PRESS)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Sent ? Snapshots.at(after, before.at()) : after;
        }
    },
    VISITS_ARE_NOT_TOLD_APART("visit", Scene.robot().with(1, Act.PRESS, Act.RAISE)) {
        @Override
        public Snapshot ahead(Snapshot before, Input input) {
            return input instanceof Input.Ready
                    ? Snapshots.allOf(before, before.visit().number())
                    : before;
        }

        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            // Restores the visit that the driver gave it.
            Pending first = before.waiting().isEmpty() ? null : before.waiting().get(0);
            return said.stream()
                    .map(output -> output instanceof Output.Begin begin
                                    && first != null
                                    && begin.pending().number() == first.number()
                            ? new Output.Begin(first)
                            : output)
                    .toList();
        }
    },
    A_STATE_IS_NOT_ENTERED_AGAIN("stuck", Scene.robot().with(1, Act.PRESS, Act.FAIL)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Failed ? Snapshots.visit(after, before.visit()) : after;
        }

        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return input instanceof Input.Failed ? without(said, Output.Enter.class::isInstance) : said;
        }
    },
    NOBODY_IS_ASKED_TO_GO_ON("stuck", Scene.robot().with(1, Act.PRESS)) {
        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return without(said, Output.Send.class::isInstance);
        }
    },
    A_STATE_IS_LEFT_BEHIND_RUNNING("visit", Scene.bulb().with(1, Act.PRESS)) {
        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return without(said, Output.Leave.class::isInstance);
        }
    },
    AN_END_LEAVES_NO_DOUBT("record", Scene.bulb().with(1, Act.PRESS, Act.END)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Recovered ? Snapshots.sure(after) : after;
        }
    },
    A_STEP_IS_WRITTEN_DOWN_AFTER_IT_WAS_SENT("record", Scene.bulb().with(1, Act.PRESS, Act.END)) {
        @Override
        public Snapshot ahead(Snapshot before, Input input) {
            Work work = before.work();
            return input instanceof Input.Recovered && work != null && work.sending()
                    ? Snapshots.work(before, Snapshots.notSent(work))
                    : before;
        }
    },
    AN_END_FORGETS_WHAT_WAITS("sum", Scene.bulb().with(1, Act.PRESS, Act.END)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Recovered ? Snapshots.waiting(after, List.of()) : after;
        }
    },
    AN_END_FORGETS_WHAT_IS_IN_PROGRESS("sum", Scene.robot().with(1, Act.PRESS, Act.END)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Recovered ? Snapshots.work(after, null) : after;
        }
    },
    AN_INTERRUPTED_PLAN_IS_MADE_ANEW("again", Scene.bulb().with(1, Act.PRESS, Act.END)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            Work work = after.work();
            return input instanceof Input.Recovered && work != null
                    ? Snapshots.work(after, Snapshots.begun(work.pending()))
                    : after;
        }
    },
    FACTS_TAKE_UP_CONTROLLERS_PLACES("room", Scene.robot().with(1, Act.PRESS).with(2, Act.OWN)) {
        @Override
        public boolean isLost(Snapshot before, Input input) {
            return isLostInAFullQueue(before, input);
        }
    },
    DEFERRED_EVENTS_TAKE_UP_THE_PLACES_OF_OTHERS("room", Scene.grinder().with(4, Act.PRESS)) {
        @Override
        public boolean isLost(Snapshot before, Input input) {
            return isLostInAFullQueue(before, input);
        }
    },
    WITHOUT_A_QUEUE_NOTHING_BEGINS("room", Scene.grinder().withQueue(0).with(1, Act.PRESS)) {
        @Override
        public boolean isLost(Snapshot before, Input input) {
            return isLostInAFullQueue(before, input);
        }
    },
    WHAT_A_STATE_DEFERS_BEGINS_ALL_THE_SAME("order", Scene.grinder().with(2, Act.PRESS)) {
        private boolean waits(Snapshot before, Input input) {
            return input instanceof Input.Ready
                    && before.work() == null
                    && before.waiting().size() == 1;
        }

        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return waits(before, input)
                    ? Snapshots.waiting(
                            Snapshots.work(
                                    after, Snapshots.begun(before.waiting().get(0))),
                            List.of())
                    : after;
        }

        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return waits(before, input)
                    ? List.of(new Output.Begin(before.waiting().get(0)))
                    : said;
        }
    },
    A_FUNCTION_IS_NOT_STARTED("function", Scene.robot().with(2, Act.PRESS)) {
        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return without(said, Output.Start.class::isInstance);
        }
    },
    A_LATE_EFFECT_MOVES_THE_DEVICE_ONLY("apart", Scene.robot().with(1, Act.PRESS, Act.GIVE_UP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Sent ? Snapshots.followOwed(after, before.followOwed()) : after;
        }
    },
    AN_ANSWER_MOVES_THE_DEVICE_ONLY("apart", Scene.bulb().with(1, Act.PRESS, Act.OWN, Act.GIVE_UP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Located ? Snapshots.followOwed(after, before.followOwed()) : after;
        }
    },
    A_LATE_REACTION_LEAVES_THE_STATES_APART("apart", Scene.slipping().with(2, Act.OWN)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Planned ? Snapshots.followOwed(after, before.followOwed()) : after;
        }
    },
    A_SWAP_LEAVES_THE_STATES_APART("apart", Scene.plainBulb().with(1, Act.PRESS, Act.OWN, Act.EVOLVE)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Evolved ? Snapshots.followOwed(after, before.followOwed()) : after;
        }
    },
    WHAT_IS_DECIDED_AGAIN_COMES_BEFORE_A_QUESTION(
            "question", Scene.bulb().outOfOrder().mute().with(2, Act.PRESS).with(1, Act.OWN, Act.JUMP, Act.GIVE_UP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            List<Pending> waiting = new ArrayList<>(after.waiting());
            if (before.work() != null
                    && after.work() == null
                    && waiting.size() > 1
                    && waiting.get(1).attempts() > 0
                    && before.waiting().contains(waiting.get(0))) {
                Collections.swap(waiting, 0, 1);
            }
            return Snapshots.waiting(after, waiting);
        }
    },
    A_FACT_THAT_FAILS_MOVES_THE_DEVICE_ONLY("apart", Scene.robot().with(1, Act.OWN, Act.FAIL)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Failed ? Snapshots.systemStays(before, after) : after;
        }

        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return said.stream()
                    .map(output -> input instanceof Input.Failed && output instanceof Output.Enter enter
                            ? new Output.Enter(enter.visit(), before.at().evolved(), enter.by(), enter.deadlines())
                            : output)
                    .toList();
        }
    },
    AN_EFFECT_THAT_IS_GIVEN_UP_KEEPS_THE_STATE(
            "obeyed", Scene.grinder().with(2, Act.PRESS).with(1, Act.GIVE_UP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.GivenUp ? Snapshots.systemStays(before, after) : after;
        }
    },
    PRESSES_HAVE_NO_AGE("age", Scene.bulb().withPressAge(2).with(2, Act.PRESS)) {
        @Override
        public Rules rules(Rules rules) {
            return new Rules(rules.table(), rules.timers(), rules.queueCapacity());
        }
    },
    A_CONTRADICTION_LEAVES_NO_DOUBT(
            "contradiction", Scene.sliding().with(2, Act.OWN).with(1, Act.LOSE)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Observed ? Snapshots.sure(after) : after;
        }
    },
    WHAT_ENDS_IS_NOT_COUNTED("sum", Scene.bulb().with(1, Act.PRESS)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Observed ? after : Snapshots.tally(after, before.tally());
        }
    };

    private final String invariant;
    private final Scene scene;

    Mutation(String invariant, Scene scene) {
        this.invariant = invariant;
        this.scene = scene;
    }

    @Override
    public String invariant() {
        return invariant;
    }

    @Override
    public Scene scene() {
        return scene;
    }
}
