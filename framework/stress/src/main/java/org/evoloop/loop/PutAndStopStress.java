package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.Z_Result;

/** The loop is closed while somebody is about to wait for room; one who waited for ever would be told as a timeout. */
@JCStressTest
@Outcome(id = "false", expect = ACCEPTABLE, desc = "refused, before or after waiting")
@Outcome(id = "true", expect = FORBIDDEN, desc = "there was no room for it")
@State
public class PutAndStopStress {
    private final Rig rig = new Rig(ThreadingModel.THREAD_PER_COMPONENT, 1);

    public PutAndStopStress() {
        rig.sequencer.offer("fills the queue");
    }

    @Actor
    public void putter(Z_Result result) {
        try {
            result.r1 = rig.sequencer.put("waits");
        } catch (InterruptedException nobodyDoes) {
            throw new AssertionError(nobodyDoes);
        }
    }

    @Actor
    public void stop() {
        rig.gate.become(LoopState.STOPPED);
    }
}
