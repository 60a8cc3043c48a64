package org.evoloop.homeassistant;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** Home Assistant cannot be reached, or has refused something. */
final class HomeException extends IOException {
    private static final long serialVersionUID = 1L;

    /** The error's code where Home Assistant has refused a request; else empty. */
    private final String code;

    HomeException(String message) {
        this("", message);
    }

    HomeException(String code, String message) {
        super(message);
        this.code = code;
    }

    boolean hasCode(String other) {
        return code.equals(other);
    }

    /** Whether a service that was called has not begun, so that it had no effect. */
    static boolean isRefusal(@Nullable Throwable failure) {
        return failure instanceof HomeException refused && refused.isRefusal();
    }

    boolean isRefusal() {
        return switch (code) {
            case "not_found", "invalid_format", "service_validation_error", "unauthorized", "not_allowed" -> true;
            default -> false;
        };
    }
}
