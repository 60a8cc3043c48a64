package org.evoloop.http;

import org.evoloop.converter.UnknownEffectException;

/** A request was not answered; it is unknown whether it arrived. */
final class UnansweredException extends UnknownEffectException {
    private static final long serialVersionUID = 1;

    UnansweredException(String message, Throwable cause) {
        super(message, cause);
    }
}
