package org.evoloop.xmi.dialect;

import java.io.InputStream;
import java.util.function.BiFunction;
import org.evoloop.statemachine.ModelException;

/** Limits the bytes that a parser reads, per token and per file. */
final class BoundedInput extends CountedInput {
    private static final int MAX_FILE_BYTES = 1 << 30;
    /** A parser keeps a whole tag, comment and the like in memory. */
    private static final int MAX_TOKEN_BYTES = 4 << 20;

    private final BiFunction<String, String, ModelException> refusal;
    private long fileBytes;
    private long tokenBytes;

    /** @param refusal makes an exception from a message and a remedy */
    BoundedInput(InputStream bytes, BiFunction<String, String, ModelException> refusal) {
        super(bytes);
        this.refusal = refusal;
    }

    /** Restarts the count, since the parser begins a new token. */
    void startToken() {
        tokenBytes = 0;
    }

    @Override
    void count(int read) {
        fileBytes += read;
        tokenBytes += read;
        if (fileBytes > MAX_FILE_BYTES) {
            throw refusal.apply("is larger than " + (MAX_FILE_BYTES >> 20) + " MiB", "export the state machines alone");
        }
        if (tokenBytes > MAX_TOKEN_BYTES) {
            throw refusal.apply(
                    "holds a single tag, text or comment of more than " + (MAX_TOKEN_BYTES >> 20) + " MiB",
                    XmiStream.EXPORT_AGAIN);
        }
    }
}
