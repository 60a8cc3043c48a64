package org.evoloop.models.scaffold;

/** A model's text inside Java source code. */
final class JavaText {
    private JavaText() {}

    /** A string literal. */
    static String literal(String text) {
        StringBuilder literal = new StringBuilder("\"");
        for (int i = 0; i < text.length(); i++) {
            char next = text.charAt(i);
            switch (next) {
                case '"', '\\' -> literal.append('\\').append(next);
                case '\n' -> literal.append("\\n");
                case '\t' -> literal.append("\\t");
                case '\r' -> literal.append("\\r");
                default -> literal.append(next);
            }
        }
        return literal.append('"').toString();
    }

    /** Text for a comment: it cannot end the comment and contains no tags or Java escapes. */
    static String comment(String text) {
        return text.replace("&", "&amp;")
                .replace("\\", "&#92;")
                .replace("*", "&#42;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("@", "&#64;")
                .replace("{", "&#123;")
                .replace("}", "&#125;")
                .replaceAll("\\s+", " ");
    }
}
