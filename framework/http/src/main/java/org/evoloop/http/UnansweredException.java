package org.evoloop.http;

import java.io.IOException;

/** A request has not been answered; whether it has arrived is not known. */
final class UnansweredException extends IOException {
    UnansweredException(String message, Throwable cause) {
        super(message, cause);
    }
}
