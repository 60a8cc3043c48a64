package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.Expect;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.IIZ_Result;

/** The carrier finishes an event while another thread replaces it; the next event waits for one of the two. */
@JCStressTest
@Outcome(id = "2, 0, false", expect = ACCEPTABLE, desc = "nobody was late: both were run")
@Outcome(id = "2, 1, false", expect = ACCEPTABLE, desc = "given up while it ran; the other one was run")
@Outcome(id = "1, 1, false", expect = ACCEPTABLE, desc = "given up before it began; the other one was run")
@Outcome(
        id = "1, 2, false",
        expect = ACCEPTABLE,
        desc = "given up while it ran, and the next came before it had returned")
@Outcome(
        id = "0, 2, false",
        expect = ACCEPTABLE,
        desc = "given up before it began, and the next came before that was known")
@Outcome(expect = Expect.FORBIDDEN, desc = "an occurrence was lost or run twice, or the component is stuck for ever")
@State
public class SuccessorStress {
    private final Rig rig = new Rig(ThreadingModel.SINGLE_CARRIER, 2).ready();
    private final CarrierThread first = rig.carrier();

    public SuccessorStress() {
        rig.sequencer.offer("late");
        rig.sequencer.offer("next");
    }

    @Actor
    public void carrier() {
        for (int round = 0; round < 2 && !first.isRetired(); round++) {
            first.runGiven();
        }
    }

    @Actor
    public void watch() {
        rig.giveUp();
    }

    @Arbiter
    public void afterwards(IIZ_Result result) {
        if (first.isRetired()) {
            first.ended();
        }
        Rig.await(() -> rig.intake.ends.get() == 2);
        rig.crew.retire();
        result.r1 = rig.runs.get();
        result.r2 = rig.givenUp.get();
        result.r3 = rig.stage.isStuck();
    }
}
