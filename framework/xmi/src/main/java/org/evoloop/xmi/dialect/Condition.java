package org.evoloop.xmi.dialect;

import java.util.Locale;
import java.util.Set;

/** Texts of conditions that have a meaning of their own in every dialect. */
public final class Condition {
    private static final Set<String> TRUE = Set.of("true", "true()");
    private static final Set<String> FALSE = Set.of("false", "false()");
    private static final Set<String> ELSE = Set.of("else", "otherwise");

    private Condition() {}

    /** The guard as in a chart: empty if it always holds, {@code else} for the remaining branch, no brackets around it. */
    public static String guard(String text) {
        String condition = withoutBrackets(text);
        if (isTrue(condition)) {
            return "";
        }
        return isElse(condition) ? "else" : condition;
    }

    /** Whether it always holds. */
    public static boolean isTrue(String condition) {
        return TRUE.contains(word(condition));
    }

    /** Whether it never holds. */
    public static boolean isFalse(String condition) {
        return FALSE.contains(word(condition));
    }

    /** Whether it holds if no other one does. */
    public static boolean isElse(String condition) {
        return ELSE.contains(word(condition));
    }

    private static String word(String condition) {
        return withoutBrackets(condition).toLowerCase(Locale.ROOT);
    }

    private static String withoutBrackets(String text) {
        String stripped = text.strip();
        return stripped.startsWith("[") && stripped.endsWith("]")
                ? stripped.substring(1, stripped.length() - 1).strip()
                : stripped;
    }
}
