package org.evoloop.journal;

/**
 * A journal cannot be read, written or continued. The message names the file, the place in it and what to do; it needs
 * no stack trace.
 *
 * @since 0.1
 */
public final class JournalException extends RuntimeException {
    private final boolean damage;

    /** @param message for people */
    public JournalException(String message) {
        super(message);
        this.damage = false;
    }

    JournalException(String message, Throwable cause) {
        super(message, cause);
        this.damage = false;
    }

    private JournalException(String message, boolean damage) {
        super(message);
        this.damage = damage;
    }

    /** An exception for damaged data; {@code what} names the file and the place in it. */
    static JournalException ofDamage(String what) {
        return new JournalException(what + ". " + Directory.DAMAGED, true);
    }

    /**
     * Whether the journal is damaged; else it is of another version or of other models, or cannot be read or written.
     */
    public boolean isDamage() {
        return damage;
    }
}
