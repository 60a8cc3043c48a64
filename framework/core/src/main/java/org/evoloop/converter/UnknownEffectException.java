package org.evoloop.converter;

import java.io.IOException;

/**
 * Thrown by {@link EventExecute#send} when it is unknown whether the step has had its effect, for example when an
 * answer did not come in time. The event fails, the record is in doubt, and the device is asked for its state before
 * anything else begins.
 *
 * @since 0.1
 */
public class UnknownEffectException extends IOException {
    private static final long serialVersionUID = 1;

    /** @param message for people: what was sent, and what is missing */
    public UnknownEffectException(String message) {
        super(message);
    }

    /** @param message for people: what was sent, and what is missing */
    public UnknownEffectException(String message, Throwable cause) {
        super(message, cause);
    }
}
