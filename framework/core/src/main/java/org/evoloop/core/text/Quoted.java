package org.evoloop.core.text;

import java.util.Locale;

/** A text of any characters, which stands in quotes. */
record Quoted(String text) {

    /** With quotes, backslashes and control characters escaped as in Java and JSON, so that it stays in its line. */
    String inQuotes() {
        StringBuilder quoted = new StringBuilder("\"");
        for (int index = 0; index < text.length(); index++) {
            char each = text.charAt(index);
            if (each == '"' || each == '\\') {
                quoted.append('\\').append(each);
            } else if (each < ' ' || each == '\u007f' || (each >= '\u0080' && !Character.isLetter(each))) {
                quoted.append(String.format(Locale.ROOT, "\\u%04x", (int) each));
            } else {
                quoted.append(each);
            }
        }
        return quoted.append('"').toString();
    }
}
