package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.Expect;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.II_Result;

/** A thread offers an event while the carrier works: no event is lost, run twice or left in the queue. */
@JCStressTest
@Outcome(id = "3, 3", expect = ACCEPTABLE, desc = "each was run once and has ended")
@Outcome(expect = Expect.FORBIDDEN, desc = "lost, run twice, or left in the queue with nobody at work")
@State
public class OneAtATimeStress {
    private final Rig rig = new Rig(ThreadingModel.SINGLE_CARRIER, 4).ready();
    private final CarrierThread carrier = rig.carrier();

    public OneAtATimeStress() {
        rig.sequencer.offer("first");
    }

    @Actor
    public void monitor() {
        rig.sequencer.offer("one");
        rig.sequencer.offer("other");
    }

    @Actor
    public void carrier() {
        carrier.runGiven();
        carrier.runGiven();
    }

    @Arbiter
    public void afterwards(II_Result result) {
        carrier.runGiven();
        carrier.runGiven();
        carrier.runGiven();
        result.r1 = rig.runs.get();
        result.r2 = rig.intake.ends.get();
    }
}
