package org.evoloop.link;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import java.util.Arrays;
import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.L_Result;

/** Two threads write at once, each more than is passed to the port in one call. */
@JCStressTest
@Outcome(id = "1122", expect = ACCEPTABLE, desc = "the first, then the second")
@Outcome(id = "2211", expect = ACCEPTABLE, desc = "the second, then the first")
@Outcome(expect = FORBIDDEN, desc = "mixed")
@State
public class WholeWritesStress {
    private static final byte[] FIRST = twoPieces(1);
    private static final byte[] SECOND = twoPieces(2);

    private final SerialWriter writer = new SerialWriter(new Port(), new SerialSettings("stress"), () -> {}, "guard");
    private String taken = "";

    private static byte[] twoPieces(int content) {
        byte[] bytes = new byte[1_025];
        Arrays.fill(bytes, (byte) content);
        return bytes;
    }

    @Actor
    public void first() {
        writer.write(FIRST);
    }

    @Actor
    public void second() {
        writer.write(SECOND);
    }

    @Arbiter
    public void afterwards(L_Result result) {
        result.r1 = taken;
    }

    private final class Port implements SerialWriter.Port {
        @Override
        public int write(byte[] bytes) {
            taken += bytes[0];
            return bytes.length;
        }

        @Override
        public int waiting() {
            return 0;
        }
    }
}
