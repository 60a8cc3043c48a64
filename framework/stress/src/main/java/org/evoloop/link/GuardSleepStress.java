package org.evoloop.link;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.Z_Result;

/**
 * A write begins, and is late at once, while the guard goes to sleep. If the guard stayed asleep, the write would block
 * forever. A guard that misses its end would block too; that is reported as a timeout.
 */
@JCStressTest
@Outcome(id = "true", expect = ACCEPTABLE, desc = "cut short")
@Outcome(id = "false", expect = FORBIDDEN, desc = "the guard sleeps while a write is late")
@State
public class GuardSleepStress {
    private static final long LIMIT_NANOS = 500_000_000;

    private final WriteGuard guard = new WriteGuard(1, () -> cut = true, "guard");
    private volatile boolean cut;

    @Actor
    public void guard() {
        guard.watch();
    }

    @Actor
    public void writer(Z_Result result) {
        long now = System.nanoTime();
        guard.begin(now);
        while (!cut && System.nanoTime() - now < LIMIT_NANOS) {
            Thread.onSpinWait();
        }
        result.r1 = cut;
        guard.done();
        guard.end(LIMIT_NANOS);
    }
}
