package org.evoloop.xmi.text;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.evoloop.xmi.dialect.Condition;

/**
 * A transition's label, {@code event, event [guard] / effect, effect «local»}, each part optional.
 *
 * @param triggers as written, with their keywords
 * @param guards usually one at most
 */
record Label(List<String> triggers, List<String> guards, List<String> effects, boolean local) {
    /** At the end of a label that Mermaid is to read, which takes a brace for that of a state. */
    static final String LOCAL = "«local»";

    /** In place of each letter of a line break in a label, which is one blank in a name. */
    static final char BREAK = '\u0001';

    private static final Pattern BREAKS = Pattern.compile("\\s*" + BREAK + "[\\s" + BREAK + "]*");
    static final List<String> LOCALS = List.of(LOCAL, "<<local>>", "{local}");

    /**
     * @param column of the text's first letter
     * @throws Refusal if it has no meaning
     */
    static Label parse(String text, int column, Syntax syntax) throws Refusal {
        String label = text.substring(0, end(text));
        String whole = label;
        String ending = LOCALS.stream().filter(whole::endsWith).findFirst().orElse("");
        label = label.substring(0, end(label.substring(0, label.length() - ending.length())));
        int slash = Marks.slash(label, syntax);
        String head = slash < 0 ? label : label.substring(0, slash);
        List<String> guards = new ArrayList<>();
        int end = end(head);
        while (end > 0 && Marks.closesAt(head, end - 1, syntax)) {
            int open = Marks.opening(head, end - 1, syntax);
            if (open < 0) {
                throw new Refusal(column + end - 1, "']' has no '[' before it; write [guard]");
            }
            String guard = Condition.guard(inOneLine(Escapes.decode(head.substring(open + 1, end - 1), syntax)));
            if (!guard.isEmpty()) {
                guards.add(0, guard);
            }
            end = end(head.substring(0, open));
        }
        int stray = Marks.bracket(head.substring(0, end), syntax);
        if (stray >= 0) {
            throw new Refusal(
                    column + stray,
                    "'" + head.charAt(stray) + "' belongs to no guard, which stands between the event and '/'; write"
                            + " event [guard] / effect, or \\" + head.charAt(stray) + " for the letter");
        }
        return new Label(
                Marks.split(head.substring(0, end), ",", syntax),
                guards,
                slash < 0 ? List.of() : Marks.split(label.substring(slash + 1), ",;", syntax),
                !ending.isEmpty());
    }

    /**
     * The slash that begins the effects, as in {@code and/or}, where it could be a letter: it has no blanks around it, and
     * no guard before it.
     *
     * @return its index, or -1
     */
    static int doubtfulSlash(String text, Syntax syntax) {
        int slash = Marks.slash(text, syntax);
        boolean clear = slash <= 0
                || text.charAt(slash - 1) == ']'
                || text.substring(slash + 1).isBlank()
                || (Character.isWhitespace(text.charAt(slash - 1)) && Character.isWhitespace(text.charAt(slash + 1)));
        return clear ? -1 : slash;
    }

    /** Where the guards at the end of a text begin; its length if there are none. */
    static int guardsAt(String head, Syntax syntax) {
        int begin = head.length();
        int end = end(head);
        while (end > 0 && Marks.closesAt(head, end - 1, syntax)) {
            int open = Marks.opening(head, end - 1, syntax);
            if (open < 0) {
                return begin;
            }
            begin = open;
            end = end(head.substring(0, open));
        }
        return begin;
    }

    /** The length of the text without blanks and line breaks at its end. */
    private static int end(String text) {
        int end = text.length();
        while (end > 0 && (Character.isWhitespace(text.charAt(end - 1)) || text.charAt(end - 1) == BREAK)) {
            end--;
        }
        return end;
    }

    /** The text with one blank for each line break. */
    private static String inOneLine(String text) {
        return text.indexOf(BREAK) < 0
                ? text
                : BREAKS.matcher(text).replaceAll(" ").strip();
    }

    /** Whether each bracket is closed. */
    static boolean isBalanced(String text) {
        int depth = 0;
        for (int i = 0; i < text.length() && depth >= 0; i++) {
            depth += text.charAt(i) == '(' ? 1 : text.charAt(i) == ')' ? -1 : 0;
        }
        return depth == 0;
    }

    /** The characters that divide a label, where they are not escaped. */
    static final class Marks {
        /** The slash before the effects, outside of guards, brackets and quotation marks; -1 if there is none. */
        static int slash(String text, Syntax syntax) {
            boolean nested = isBalanced(text);
            boolean quoted = false;
            int depth = 0;
            int round = 0;
            for (int i = 0; i < text.length(); i = next(text, i, syntax)) {
                char letter = plain(text, i, syntax);
                quoted ^= letter == '"' && (quoted || text.indexOf('"', i + 1) > 0);
                depth += quoted ? 0 : letter == '[' ? 1 : letter == ']' && depth > 0 ? -1 : 0;
                round += !nested || quoted ? 0 : letter == '(' ? 1 : letter == ')' ? -1 : 0;
                if (letter == '/' && depth == 0 && round == 0 && !quoted) {
                    return i;
                }
            }
            return -1;
        }

        static boolean closesAt(String text, int index, Syntax syntax) {
            return text.charAt(index) == ']' && (index == 0 || Escapes.lengthAt(text, index - 1, syntax) != 2);
        }

        /** The bracket that the one at {@code close} closes; -1 if there is none. */
        static int opening(String text, int close, Syntax syntax) {
            List<Integer> open = new ArrayList<>();
            for (int i = 0; i < close; i = next(text, i, syntax)) {
                char letter = plain(text, i, syntax);
                if (letter == '[') {
                    open.add(i);
                } else if (letter == ']' && !open.isEmpty()) {
                    open.remove(open.size() - 1);
                }
            }
            return open.isEmpty() ? -1 : open.get(open.size() - 1);
        }

        /** The first bracket; -1 if there is none. */
        static int bracket(String text, Syntax syntax) {
            for (int i = 0; i < text.length(); i = next(text, i, syntax)) {
                char letter = plain(text, i, syntax);
                if (letter == '[' || letter == ']') {
                    return i;
                }
            }
            return -1;
        }

        /** The parts between separators that are neither in round brackets, quotation marks nor keywords. */
        static List<String> split(String text, String separators, Syntax syntax) {
            List<String> parts = new ArrayList<>();
            boolean nested = isBalanced(text);
            boolean quoted = false;
            int depth = 0;
            int from = 0;
            for (int i = 0; i < text.length(); i = next(text, i, syntax)) {
                char letter = plain(text, i, syntax);
                quoted ^= letter == '"';
                depth += !nested || quoted ? 0 : letter == '(' ? 1 : letter == ')' ? -1 : 0;
                if (depth == 0 && !quoted && separators.indexOf(letter) >= 0 && !isInKeyword(text, i)) {
                    add(text.substring(from, i), syntax, parts);
                    from = i + 1;
                }
            }
            add(text.substring(from), syntax, parts);
            return parts;
        }

        /** Whether keywords in guillemets, or in two angle brackets, have begun before and end after {@code index}. */
        private static boolean isInKeyword(String text, int index) {
            return isBetween("«", "»", text, index) || isBetween("<<", ">>", text, index);
        }

        private static boolean isBetween(String open, String close, String text, int index) {
            return text.lastIndexOf(open, index) > text.lastIndexOf(close, index) && text.indexOf(close, index) >= 0;
        }

        private static void add(String part, Syntax syntax, List<String> parts) {
            String decoded = inOneLine(Escapes.decode(part, syntax));
            if (!decoded.isEmpty()) {
                parts.add(decoded);
            }
        }

        private static int next(String text, int index, Syntax syntax) {
            return index + Math.max(1, Escapes.lengthAt(text, index, syntax));
        }

        /** The letter, or 0 if it begins an escape. */
        private static char plain(String text, int index, Syntax syntax) {
            return Escapes.lengthAt(text, index, syntax) > 0 ? 0 : text.charAt(index);
        }
    }
}
