package org.evoloop.link;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.ZZ_Result;

/**
 * A write races with the end of the writer, after which the port is closed: no write may touch the port from then on.
 */
@JCStressTest
@Outcome(id = "true, false", expect = ACCEPTABLE, desc = "written before the end")
@Outcome(id = "false, false", expect = ACCEPTABLE, desc = "refused")
@Outcome(expect = FORBIDDEN, desc = "the port was touched after it was closed")
@State
public class WriteOrEndStress {
    private static final byte[] BYTES = {(byte) 135};
    private static final int LOOKS = 200;
    private static final long LIMIT_NANOS = 1_000_000_000;

    private final SerialWriter writer = new SerialWriter(new Port(), new SerialSettings("stress"), () -> {}, "guard");
    private volatile boolean closed;
    private boolean touched;

    @Actor
    public void writer(ZZ_Result result) {
        result.r1 = writer.write(BYTES) == SerialWriter.Outcome.WRITTEN;
        result.r2 = touched;
    }

    @Actor
    public void end() {
        closed = writer.end(LIMIT_NANOS);
    }

    private final class Port implements SerialWriter.Port {
        @Override
        public int write(byte[] bytes) {
            // Takes about as long as a short write.
            for (int look = 0; look < LOOKS; look++) {
                touched |= closed;
            }
            return bytes.length;
        }

        @Override
        public int waiting() {
            return 0;
        }
    }
}
