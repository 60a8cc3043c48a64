package org.evoloop.studio;

/** A text is no model. */
public final class MistakeException extends RuntimeException {
    private final transient Mistake mistake;

    MistakeException(Mistake mistake) {
        super(mistake.path() + ", line " + mistake.line() + ": " + mistake.message());
        this.mistake = mistake;
    }

    /** What is wrong with it. */
    public Mistake mistake() {
        return mistake;
    }
}
