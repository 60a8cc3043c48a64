package org.evoloop.xmi.astah;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.function.LongFunction;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFile;

/** A document of 1 GiB that is generated while it is read: a beginning, then one unit after another. */
final class Attack extends InputStream {
    private static final int CHUNK = 1 << 14;

    static final String HEAD = AstahDocument.HEAD;
    static final String MACHINE = HEAD + "<UML:StateMachine xmi.id=\"m\" name=\"M\">";
    static final String TRANSITIONS = MACHINE + "<UML:StateMachine.transitions>";
    static final String REFERENCES = TRANSITIONS + "<UML:Transition><UML:Transition.stateMachine>";

    private final LongFunction<String> units;
    private long bytesLeft = 1L << 30;
    private long nextUnit;
    private byte[] chunk;
    private int position;

    private Attack(String beginning, LongFunction<String> units) {
        this.units = units;
        this.chunk = beginning.getBytes(StandardCharsets.UTF_8);
    }

    /** The reader's error for {@code beginning} followed by units 0, 1, 2 and so on. */
    static String answer(String beginning, LongFunction<String> units) {
        try {
            return ModelFile.read("F.xml", new Attack(beginning, units))
                            .machines()
                            .size() + " machines";
        } catch (ModelException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    static String answer(String beginning, String unit) {
        return answer(beginning, index -> unit);
    }

    @Override
    public int read() {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] buffer, int offset, int length) {
        if (position == chunk.length) {
            if (bytesLeft < 0) {
                return -1;
            }
            StringBuilder next = new StringBuilder();
            while (next.length() < CHUNK) {
                next.append(units.apply(nextUnit++));
            }
            chunk = next.toString().getBytes(StandardCharsets.UTF_8);
            position = 0;
            bytesLeft -= chunk.length;
        }
        int count = Math.min(length, chunk.length - position);
        System.arraycopy(chunk, position, buffer, offset, count);
        position += count;
        return count;
    }
}
