package org.evoloop.engine.codec;

import java.util.Locale;

/** Quoted texts of any characters. */
final class Quoted {
    private Quoted() {}

    /**
     * Adds {@code words}, with quotes, backslashes and control characters escaped as in Java and JSON: it stays in its
     * line.
     */
    static void append(StringBuilder text, String words) {
        text.append('"');
        for (int index = 0; index < words.length(); index++) {
            char each = words.charAt(index);
            if (each == '"' || each == '\\') {
                text.append('\\').append(each);
            } else if (each < ' ' || each == '\u007f' || (each >= '\u0080' && !Character.isLetter(each))) {
                text.append(String.format(Locale.ROOT, "\\u%04x", (int) each));
            } else {
                text.append(each);
            }
        }
        text.append('"');
    }
}
