package org.evoloop.studio;

import org.evoloop.payload.JsonObject;

/** A request is not done as it is. */
public final class RequestException extends RuntimeException {
    static final int BAD = 400;
    static final int FORBIDDEN = 403;
    static final int NOT_FOUND = 404;
    static final int CONFLICT = 409;
    static final int REFUSED = 422;

    private final int status;
    private final transient JsonObject answer;

    /** It makes no sense; the message says why. */
    public RequestException(String message) {
        this(BAD, message);
    }

    RequestException(int status, String message) {
        this(status, new JsonObject().put("error", message), message);
    }

    RequestException(int status, JsonObject answer, String message) {
        super(message);
        this.status = status;
        this.answer = answer;
    }

    int status() {
        return status;
    }

    JsonObject answer() {
        return answer;
    }
}
