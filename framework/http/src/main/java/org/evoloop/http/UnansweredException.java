package org.evoloop.http;

import org.evoloop.converter.UnknownEffectException;

/** A request has not been answered; whether it has arrived is not known. */
final class UnansweredException extends UnknownEffectException {
    private static final long serialVersionUID = 1;

    UnansweredException(String message, Throwable cause) {
        super(message, cause);
    }
}
