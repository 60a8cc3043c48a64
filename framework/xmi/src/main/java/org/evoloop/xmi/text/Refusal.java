package org.evoloop.xmi.text;

/** What cannot be understood, with the column of the reason, counted from 1. */
final class Refusal extends Exception {
    private static final long serialVersionUID = 1L;

    private final int column;

    Refusal(int column, String message) {
        super(message, null, false, false);
        this.column = column;
    }

    /** The message behind the column. */
    String text() {
        return "column " + column + ": " + getMessage();
    }
}
