package org.evoloop.journal;

/** The kind of an input, with which its record begins. Codes are never changed; a new kind gets a new code. */
enum Kind {
    OPENED(1),
    CLOSING(2),
    CLOSED(3),
    RECOVERED(4),
    OBSERVED(5),
    TIMER_DUE(6),
    READY(7),
    PLANNED(8),
    DISMISSED(9),
    SENDING(10),
    SENT(11),
    RUNNING(12),
    EFFECT_RUN(13),
    LOCATED(14),
    FAILED(15),
    GIVEN_UP(16),
    CHANGED(17);

    private static final Kind[] ALL = values();

    private final int code;

    Kind(int code) {
        this.code = code;
    }

    int code() {
        return code;
    }

    static Kind of(int code) {
        for (Kind kind : ALL) {
            if (kind.code == code) {
                return kind;
            }
        }
        throw new IllegalArgumentException("there is no input of kind " + code);
    }
}
