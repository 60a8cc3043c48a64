package org.evoloop.learn;

/** Learning cannot go on; the best machine so far is the result, and the message is what is open. */
final class OpenEndException extends RuntimeException {
    private static final long serialVersionUID = 1;

    OpenEndException(String message) {
        super(message);
    }
}
