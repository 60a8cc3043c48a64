package org.evoloop.mqtt;

import org.jspecify.annotations.Nullable;

/** A broker cannot be reached, or refuses something; the message is for people and says what to do. */
final class BrokerException extends Exception {
    private static final long serialVersionUID = 1;

    BrokerException(String message) {
        super(message);
    }

    BrokerException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}
