package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.Expect;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.IIII_Result;

/** One thread offers an event while another closes the loop. */
@JCStressTest
@Outcome(id = "2, 0, 2, 0", expect = ACCEPTABLE, desc = "both waited and were refused")
@Outcome(id = "1, 0, 2, 0", expect = ACCEPTABLE, desc = "one waited, the other found the loop closed")
@Outcome(id = "0, 0, 2, 0", expect = ACCEPTABLE, desc = "both found the loop closed")
@Outcome(expect = Expect.FORBIDDEN, desc = "what was observed is not accounted for")
@State
public class OfferAndStopStress {
    private final Rig rig = new Rig(ThreadingModel.CALLER, 4).ready();

    @Actor
    public void monitor() {
        rig.sequencer.offer("one");
        rig.sequencer.offer("other");
    }

    @Actor
    public void stop() {
        rig.gate.become(LoopState.STOPPED);
    }

    @Arbiter
    public void afterwards(IIII_Result result) {
        QueueStatus queue = rig.sequencer.queueStatus();
        result.r1 = (int) queue.taken();
        result.r2 = queue.depth();
        result.r3 = (int) queue.refused();
        result.r4 = (int) queue.dropped();
    }
}
