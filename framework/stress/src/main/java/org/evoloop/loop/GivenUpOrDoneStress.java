package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.Expect;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.IIII_Result;

/** A component returns, or is about to begin, while it is given up. */
@JCStressTest
@Outcome(id = "1, 1, 0, 0", expect = ACCEPTABLE, desc = "done")
@Outcome(id = "1, 1, 1, 0", expect = ACCEPTABLE, desc = "given up while it ran; what it returned was ignored")
@Outcome(id = "0, 1, 1, 0", expect = ACCEPTABLE, desc = "given up before it began, and not begun")
@Outcome(
        expect = Expect.FORBIDDEN,
        desc = "the cycle has ended twice or not at all, or the component counts as stuck for ever")
@State
public class GivenUpOrDoneStress {
    private final Rig rig = new Rig(ThreadingModel.THREAD_PER_COMPONENT, 1).ready();

    public GivenUpOrDoneStress() {
        rig.sequencer.offer("occurrence");
    }

    @Actor
    public void component() {
        rig.stage.runGiven();
    }

    @Actor
    public void watch() {
        rig.giveUp();
    }

    @Arbiter
    public void afterwards(IIII_Result result) {
        result.r1 = rig.runs.get();
        result.r2 = rig.intake.ends.get();
        result.r3 = rig.givenUp.get();
        result.r4 = rig.stage.isStuck() ? 1 : 0;
    }
}
