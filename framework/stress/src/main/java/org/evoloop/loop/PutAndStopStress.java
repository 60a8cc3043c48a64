package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.jspecify.annotations.Nullable;
import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.ZZ_Result;

/** The loop is closed while a thread is about to wait for room in the queue. */
@JCStressTest
@Outcome(id = "false, false", expect = ACCEPTABLE, desc = "refused, before or after waiting")
@Outcome(id = "true, false", expect = FORBIDDEN, desc = "taken although there was no room")
@Outcome(id = "false, true", expect = FORBIDDEN, desc = "waited on, and nobody would have come")
@State
public class PutAndStopStress {
    private final Rig rig = new Rig(ThreadingModel.THREAD_PER_COMPONENT, 1);

    private volatile @Nullable Thread putter;
    private volatile boolean done;

    public PutAndStopStress() {
        rig.sequencer.offer("fills the queue");
    }

    @Actor
    public void putter(ZZ_Result result) {
        putter = Thread.currentThread();
        try {
            result.r1 = rig.sequencer.put("waits");
        } catch (InterruptedException forgotten) {
            result.r2 = true;
        }
        done = true;
    }

    @Actor
    public void stop() {
        rig.gate.become(LoopState.STOPPED);
        while (!Rig.await(() -> done)) {
            Thread waiting = putter;
            if (waiting != null) {
                waiting.interrupt();
            }
        }
    }
}
