package org.evoloop.xmi.text;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * How a text contains characters that would mean something else: a backslash before it in both languages, {@code #44;}
 * and {@code #quot;} in Mermaid, {@code <U+002C>} and the numeric entities of HTML in PlantUML. An escaped comma separates nothing.
 */
final class Escapes {
    /** The characters that have a meaning in a label. */
    private static final String SPECIAL = ",;/[]{}()\"\\";

    private static final Map<String, String> NAMED = Map.of(
            "quot", "\"", "amp", "&", "lt", "<", "gt", ">", "apos", "'", "nbsp", " ", "semi", ";", "comma", ",", "sol",
            "/", "num", "#");

    /** Longer than any character's number. */
    private static final int LONGEST = 12;

    private Escapes() {}

    /** The length of the escape that begins at this index; 0 if none does. */
    static int lengthAt(String text, int index, Syntax syntax) {
        char first = text.charAt(index);
        if (first == '\\') {
            return index + 1 < text.length() && SPECIAL.indexOf(text.charAt(index + 1)) >= 0 ? 2 : 0;
        }
        String prefix = prefix(first, syntax);
        if (prefix.isEmpty() || !text.startsWith(prefix, index)) {
            return 0;
        }
        int end = text.indexOf(first == '<' ? '>' : ';', index);
        if (end < 0 || end - index > LONGEST) {
            return 0;
        }
        return decoded(text.substring(index + prefix.length(), end), first) == null ? 0 : end + 1 - index;
    }

    private static String prefix(char first, Syntax syntax) {
        if (syntax == Syntax.MERMAID) {
            return first == '#' ? "#" : "";
        }
        return first == '<' ? "<U+" : first == '&' ? "&#" : "";
    }

    private static @Nullable String decoded(String code, char first) {
        if (first == '#' && NAMED.containsKey(code)) {
            return NAMED.get(code);
        }
        try {
            int number = Integer.parseInt(code, first == '<' ? 16 : 10);
            return Character.isValidCodePoint(number) && number > 0 ? Character.toString(number) : null;
        } catch (NumberFormatException notANumber) {
            return null;
        }
    }

    /** The text with its escapes replaced by the characters that they stand for, stripped. */
    static String decode(String text, Syntax syntax) {
        StringBuilder plain = null;
        int copied = 0;
        for (int i = 0; i < text.length(); i++) {
            int length = lengthAt(text, i, syntax);
            if (length > 0) {
                plain = plain == null ? new StringBuilder() : plain;
                plain.append(text, copied, i);
                char first = text.charAt(i);
                String prefix = prefix(first, syntax);
                plain.append(
                        first == '\\'
                                ? text.substring(i + 1, i + 2)
                                : decoded(text.substring(i + prefix.length(), i + length - 1), first));
                copied = i + length;
                i = copied - 1;
            }
        }
        return (plain == null ? text : plain.append(text, copied, text.length()).toString()).strip();
    }
}
