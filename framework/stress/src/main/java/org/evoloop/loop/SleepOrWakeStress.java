package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.ZZ_Result;

/** A thread goes to sleep while it is given work. */
@JCStressTest
@Outcome(id = "true, true", expect = ACCEPTABLE, desc = "it sleeps and is woken")
@Outcome(id = "false, true", expect = ACCEPTABLE, desc = "it is woken although it has seen its work")
@Outcome(id = "false, false", expect = ACCEPTABLE, desc = "it stays awake")
@Outcome(id = "true, false", expect = FORBIDDEN, desc = "it sleeps with work in its slot, and nobody wakes it")
@State
public class SleepOrWakeStress {
    private static final StageWorker<Object> STAGE = new Rig(ThreadingModel.CALLER, 1).stage;

    private final CarrierThread carrier = new CarrierThread(STAGE, "stress", WaitStrategy.PARK);

    @Actor
    public void sleeper(ZZ_Result result) {
        result.r1 = carrier.maySleep();
    }

    @Actor
    public void giver(ZZ_Result result) {
        carrier.give(STAGE);
        result.r2 = carrier.hasToBeWoken();
    }
}
