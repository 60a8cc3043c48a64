package org.evoloop.engine.codec;

/**
 * A text or bytes are not what was written, or do not fit the models. The message names the place, what is wrong there,
 * and what to do; it needs no stack trace.
 *
 * @since 0.1
 */
public final class CodecException extends RuntimeException {
    CodecException(String message) {
        super(message);
    }
}
