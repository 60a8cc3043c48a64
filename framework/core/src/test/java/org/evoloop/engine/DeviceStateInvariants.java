package org.evoloop.engine;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** What must hold of states that need the device somewhere; see {@link Invariants}. */
record DeviceStateInvariants(Snapshot before, @Nullable Input input, List<Output> said, Snapshot after, World world) {
    /** Which one is violated, and how; empty if none is. */
    static String check(Snapshot before, @Nullable Input input, List<Output> said, Snapshot after, World world) {
        DeviceStateInvariants invariants = new DeviceStateInvariants(before, input, said, after, world);
        return List.of(
                        invariants.theDeviceIsWhereItIsNeeded(),
                        invariants.functionsStartWhereTheDeviceIsNeeded(),
                        invariants.nothingIsDecidedWithTheDeviceElsewhere(),
                        invariants.plansReachTheDeviceState(),
                        invariants.anInterruptedPlanEndsWhereItLed(),
                        invariants.whatIsDecidedAgainIsNoOtherPress(),
                        invariants.timersBeginWhenTheDeviceIsThere())
                .stream()
                .filter(problem -> !problem.isEmpty())
                .findFirst()
                .orElse("");
    }

    /** Whatever has failed, and whatever the device did: in the end it is where the new model's state needs it. */
    private String theDeviceIsWhereItIsNeeded() {
        boolean quiet = after.open() && after.work() == null && after.waiting().isEmpty() && !after.followOwed();
        return quiet && !Invariants.isInDoubt(after) && !isWhereNeeded(after.at())
                ? "needed: nothing brings the new model from " + after.at()
                : "";
    }

    private boolean isWhereNeeded(Configuration at) {
        return world.rules().table().isWhereNeeded(at);
    }

    /** The function of a state that needs the device starts only where that is certain, and nothing else is to be heard. */
    private String functionsStartWhereTheDeviceIsNeeded() {
        boolean needs = world.rules().table().needsDevice(after.at().evolved());
        boolean certain = isWhereNeeded(after.at())
                && !Invariants.isInDoubt(after)
                && after.waiting().stream().noneMatch(Pending::hasHappened);
        return needs && !certain && said.stream().anyMatch(Output.Start.class::isInstance)
                ? "start: a function in " + after
                : "";
    }

    private String nothingIsDecidedWithTheDeviceElsewhere() {
        for (Output output : said) {
            if (output instanceof Output.Decided decided
                    && !decided.pending().goesFirst()
                    && !isInDoubtAbout(decided.pending())
                    && !isWhereNeeded(before.at())) {
                return "elsewhere: " + decided + " with the device where it is not needed";
            }
        }
        return "";
    }

    /** What a function sends does not take the device out of the state's device state, either. */
    private String plansReachTheDeviceState() {
        for (Output output : said) {
            if (output instanceof Output.Decided decided
                    && decided.pending().own() == null
                    && (decided.decision() instanceof Decision.NewState
                            || decided.decision() instanceof Decision.Sending)
                    && !(decided.pending().occurrence() instanceof Occurrence.Evolved)
                    && !isWhereNeeded(decided.decision().after())) {
                return "reached: " + decided;
            }
        }
        return "";
    }

    /** A step whose effect was unknown has taken the device to where its plan leads: then the transition is taken. */
    private String anInterruptedPlanEndsWhereItLed() {
        Doubt doubt = before.doubt();
        Decision interrupted = doubt == null ? null : doubt.interrupted();
        boolean decided =
                input instanceof Input.Located || (input instanceof Input.Planned && tellsWhere(before.work()));
        if (interrupted == null
                || !decided
                || Invariants.isInDoubt(after)
                || (after.doubt() != null && after.doubt().interrupted() != null)
                || !before.at().evolved().equals(interrupted.before().evolved())
                || !isWhereNeeded(interrupted.after().withOriginal(after.at().original()))) {
            return "";
        }
        Work work = after.work();
        boolean goesOn = work != null && work.decision() instanceof Decision.NewState;
        return goesOn || after.at().evolved().equals(interrupted.after().evolved())
                ? ""
                : "interrupted: " + interrupted + " ends in " + after.at();
    }

    private static boolean tellsWhere(@Nullable Work work) {
        return work != null
                && (work.pending().occurrence() instanceof Occurrence.Found
                        || work.pending().occurrence() instanceof Occurrence.InDoubt);
    }

    private boolean isInDoubtAbout(Pending pending) {
        Doubt doubt = before.doubt();
        return doubt != null && doubt.number() == pending.number();
    }

    /** Once it is known where the device is, the new model does not follow it to where what is decided again has sent it. */
    private String whatIsDecidedAgainIsNoOtherPress() {
        boolean follows = !before.followOwed() && after.followOwed() && !Invariants.isInDoubt(after);
        boolean answers = input instanceof Input.Located
                || (input instanceof Input.Observed observed && observed.occurrence() instanceof Occurrence.Found);
        return follows
                        && answers
                        && before.waiting().stream().noneMatch(Pending::hasHappened)
                        && after.waiting().stream().anyMatch(this::isInDoubtAbout)
                ? "another: the new model follows to " + after.at() + " what " + after.waiting() + " has done"
                : "";
    }

    /** When other models have sent the device to where their state needs it, the timers of that state begin. */
    private String timersBeginWhenTheDeviceIsThere() {
        for (Output output : said) {
            if (Snapshots.isOfOtherModels(before.work())
                    && output instanceof Output.Enter enter
                    && world.rules().table().needsDevice(enter.state())) {
                for (Map.Entry<Event, Duration> timer :
                        world.rules().timers().of(enter.state()).entrySet()) {
                    long full = after.nowNanos() + timer.getValue().toNanos();
                    if (enter.deadlines().getOrDefault(timer.getKey(), 0L) < full) {
                        return "time: " + enter + " at " + after.nowNanos();
                    }
                }
            }
        }
        return "";
    }
}
