package org.evoloop.engine;

import java.util.List;
import org.evoloop.engine.Scene.Act;
import org.evoloop.evolution.Occurrence;

/** Those of the mechanisms without which new states that need the device somewhere would be wrong; see {@link Mutation}. */
enum DeviceStateMutation implements Removal {
    A_DEVICE_ELSEWHERE_IS_NOT_FOLLOWED("stuck", DeviceStateScenes.fan().with(1, Act.PRESS, Act.FAIL)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return Snapshots.followOwed(after, before.followOwed());
        }
    },
    A_START_THAT_HAS_TO_WAIT_IS_FORGOTTEN("function", DeviceStateScenes.fan().with(1, Act.PRESS, Act.GIVE_UP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return Snapshots.visit(after, Snapshots.owingNoStart(after.visit()));
        }
    },
    A_DOUBT_FORGETS_ITS_DECISION("interrupted", DeviceStateScenes.fan().with(1, Act.PRESS, Act.END)) {
        @Override
        public Snapshot ahead(Snapshot before, Input input) {
            return input instanceof Input.Located ? Snapshots.forgettingItsDecision(before) : before;
        }
    },
    A_QUESTION_FORGETS_WHAT_A_REPORT_COMPLETES(
            "interrupted", DeviceStateScenes.fan().with(1, Act.PRESS, Act.END, Act.JUMP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            boolean isAsked =
                    before.work() != null && before.work().pending().occurrence() instanceof Occurrence.InDoubt;
            boolean isReported = after.doubt() != null && after.doubt().settled();
            return input instanceof Input.Planned && isAsked && isReported
                    ? Snapshots.forgettingItsDecision(after)
                    : after;
        }
    },
    WHAT_IS_DECIDED_AGAIN_IS_TAKEN_FOR_ANOTHER_PRESS(
            "another", DeviceStateScenes.air().outOfOrder().with(2, Act.PRESS).with(1, Act.JUMP)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            Doubt doubt = after.doubt();
            boolean waits = doubt != null
                    && doubt.settled()
                    && after.waiting().stream().anyMatch(pending -> pending.number() == doubt.number());
            boolean isWhereNeeded = scene().rules().table().isWhereNeeded(after.at());
            return Snapshots.followOwed(after, after.followOwed() || (waits && !isWhereNeeded));
        }
    },
    A_SWAP_KEEPS_A_STATE_WITH_THE_DEVICE_ELSEWHERE(
            "needed", DeviceStateScenes.restingFan().with(2, Act.PRESS).with(1, Act.FAIL, Act.EVOLVE)) {
        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return input instanceof Input.Evolved ? Snapshots.followOwed(after, before.followOwed()) : after;
        }
    },
    A_TIMER_KEEPS_THE_TIME_BEFORE_THE_DEVICE_ARRIVED(
            "time", DeviceStateScenes.boostedFan().with(1, Act.PRESS, Act.EVOLVE)) {
        private boolean arrives(Snapshot before, Input input) {
            return input instanceof Input.Sent && Snapshots.isOfOtherModels(before.work());
        }

        @Override
        public Snapshot undo(Snapshot before, Input input, Snapshot after) {
            return arrives(before, input)
                    ? Snapshots.visit(
                            after, Snapshots.due(after.visit(), before.visit().deadlines()))
                    : after;
        }

        @Override
        public List<Output> unsay(Snapshot before, Input input, List<Output> said) {
            return said.stream()
                    .map(output -> arrives(before, input) && output instanceof Output.Enter enter
                            ? new Output.Enter(
                                    enter.visit(),
                                    enter.state(),
                                    enter.by(),
                                    before.visit().deadlines())
                            : output)
                    .toList();
        }
    };

    private final String invariant;
    private final Scene scene;

    DeviceStateMutation(String invariant, Scene scene) {
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
