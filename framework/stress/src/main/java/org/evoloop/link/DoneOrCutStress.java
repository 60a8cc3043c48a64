package org.evoloop.link;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.ZZ_Result;

/** A write returns at the very moment its time is up: it was either in time or cut short, never both. */
@JCStressTest
@Outcome(id = "true, false", expect = ACCEPTABLE, desc = "in time")
@Outcome(id = "false, true", expect = ACCEPTABLE, desc = "cut short")
@Outcome(id = "true, true", expect = FORBIDDEN, desc = "in time, and what the line held was dropped")
@Outcome(id = "false, false", expect = FORBIDDEN, desc = "late, and what the line held was sent all the same")
@State
public class DoneOrCutStress {
    private final WriteGuard guard = new WriteGuard(1, () -> cut = true, "guard");
    private volatile boolean cut;

    public DoneOrCutStress() {
        guard.begin(System.nanoTime());
    }

    @Actor
    public void guard() {
        guard.watch();
    }

    @Actor
    public void writer(ZZ_Result result) {
        result.r1 = guard.done();
        guard.end(0);
    }

    @Arbiter
    public void afterwards(ZZ_Result result) {
        result.r2 = cut;
    }
}
