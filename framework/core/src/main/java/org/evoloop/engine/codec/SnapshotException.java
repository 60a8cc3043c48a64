package org.evoloop.engine.codec;

/**
 * A text is not a snapshot from which a core can continue. The message names the line, what is wrong there, and what to
 * do; it needs no stack trace.
 *
 * @since 0.1
 */
public final class SnapshotException extends RuntimeException {
    SnapshotException(String message) {
        super(message);
    }
}
