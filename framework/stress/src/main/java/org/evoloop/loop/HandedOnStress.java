package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;

import java.util.List;
import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.Expect;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.II_Result;

/** A component hands on to the next one, which is given up as soon as it has the turn; another occurrence waits. */
@JCStressTest
@Outcome(id = "0, 0", expect = ACCEPTABLE, desc = "done, or not yet begun when it was looked at")
@Outcome(id = "1, 0", expect = ACCEPTABLE, desc = "given up before it began, and not begun")
@Outcome(expect = Expect.FORBIDDEN, desc = "the next one counts as stuck although it has nothing to do")
@State
public class HandedOnStress {
    private static final int LOOKS = 1000;

    private final Rig rig = new Rig(ThreadingModel.THREAD_PER_COMPONENT, 2);
    private final StageWorker<Object> next =
            new StageWorker<>(new Rig.Nothing(), rig.crew, rig.sequencer, (by, input) -> by.handOn(null, null));
    private final StageWorker<Object> first =
            new StageWorker<>(new Rig.Nothing(), rig.crew, rig.sequencer, (by, input) -> by.handOn(input, next));

    public HandedOnStress() {
        rig.pipeline.lead(first, null, List.of());
        rig.sequencer.offer("one");
        rig.sequencer.offer("other");
    }

    @Actor
    public void component() {
        first.runGiven();
    }

    /** Looks for a while, to come right after the turn has been handed on. */
    @Actor
    public void watch() {
        for (int looks = 0; looks < LOOKS && rig.sequencer.busy() != next; looks++) {
            Thread.onSpinWait();
        }
        rig.giveUp(next);
    }

    @Arbiter
    public void afterwards(II_Result result) {
        if (next.ownThread() instanceof CarrierThread own) {
            own.runGiven();
        }
        result.r1 = rig.givenUp.get();
        result.r2 = next.isStuck() ? 1 : 0;
    }
}
