package org.evoloop.journal;

import java.nio.file.Path;

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

    /** An exception for a damaged segment; {@code what} follows the name of the file, and may begin with a place. */
    static JournalException ofDamage(Path file, String what) {
        return damaged(file + (what.startsWith(",") ? "" : ": ") + what, Remedy.ofDamage(file));
    }

    /** An exception for a journal that is not as it was written. */
    static JournalException damaged(String what, String remedy) {
        return new JournalException(what + ". The journal is damaged; " + remedy, true);
    }

    /**
     * Whether the journal is damaged; else it is of another version or of other models, or cannot be read or written.
     */
    public boolean isDamage() {
        return damage;
    }
}
