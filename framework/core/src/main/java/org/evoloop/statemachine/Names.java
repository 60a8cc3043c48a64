package org.evoloop.statemachine;

import static java.util.Objects.requireNonNull;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * Names in messages: on one line, and with suggestions for a misspelt one. A name may have any characters, since those of
 * models have: a guard drawn over two lines, for example.
 *
 * <p>Threading: pure functions, which any thread may call.
 *
 * @since 0.1
 */
public final class Names {
    private static final int NEAREST = 3;
    private static final int LISTED = 20;

    /** A longer name is not a typing error, and the search for similar ones takes time quadratic in its length. */
    private static final int LONGEST = 200;

    private Names() {}

    /**
     * {@code name} for messages, truncated to {@value #LONGEST} characters and {@linkplain #inOneLine in one line}.
     */
    public static String shown(String name) {
        String begin =
                name.length() <= LONGEST ? name : name.substring(0, LONGEST) + "... (" + name.length() + " letters)";
        return inOneLine(begin);
    }

    /**
     * {@code text} with {@code ?} for each line break and other control character but tabs, since these could look like
     * another line or change the terminal.
     */
    public static String inOneLine(String text) {
        // By hand, for speed: nearly all text is plain, and is returned without a copy.
        for (int index = 0; index < text.length(); index++) {
            if (isControl(text.charAt(index))) {
                StringBuilder plain = new StringBuilder(text);
                for (int at = index; at < text.length(); at++) {
                    if (isControl(text.charAt(at))) {
                        plain.setCharAt(at, '?');
                    }
                }
                return plain.toString();
            }
        }
        return text;
    }

    private static boolean isControl(char letter) {
        return (Character.isISOControl(letter) && letter != '\t') || letter == '\u2028' || letter == '\u2029';
    }

    /** @throws NullPointerException with {@code message} if {@code names} is null or holds null */
    static void requireAll(Collection<String> names, String message) {
        // Most are empty, and an iterator for each of a hundred thousand transitions would be garbage.
        if (!requireNonNull(names, message).isEmpty()) {
            names.forEach(name -> requireNonNull(name, message));
        }
    }

    /**
     * For messages: {@code "; did you mean Clean?"}, else, if no name is near, what there is.
     *
     * @param known what there is
     */
    public static String hint(String wrong, Collection<?> known) {
        String meant = meant(wrong, known);
        if (!meant.isEmpty()) {
            return meant;
        }
        List<String> listed =
                known.stream().map(Object::toString).sorted().limit(LISTED).toList();
        return "; there is " + (listed.isEmpty() ? "none" : String.join(", ", listed))
                + (known.size() > LISTED ? " and " + (known.size() - LISTED) + " more" : "");
    }

    /** For messages: {@code "; did you mean Clean?"}; empty if no name is near. */
    public static String meant(String wrong, Collection<?> known) {
        List<String> near = nearest(wrong, known.stream().map(Object::toString));
        return near.isEmpty() ? "" : "; did you mean " + String.join(" or ", near) + "?";
    }

    /** Names that differ by few letters, or only in capitals, blanks, hyphens and the like; the nearest first. */
    private static List<String> nearest(String wrong, Stream<String> known) {
        if (wrong.length() > LONGEST) {
            return List.of();
        }
        String plain = plain(wrong);
        int most = Math.max(1, wrong.length() / 3);
        return known.distinct()
                .filter(name -> distance(plain, plain(name)) <= most)
                .sorted(Comparator.<String>comparingInt(name -> distance(plain, plain(name)))
                        .thenComparing(name -> name))
                .limit(NEAREST)
                .toList();
    }

    private static String plain(String name) {
        // By hand, for speed: misspelt events may come in large numbers.
        StringBuilder plain = new StringBuilder(name.length());
        for (int index = 0; index < name.length(); index++) {
            char letter = name.charAt(index);
            if (!Character.isWhitespace(letter) && letter != '_' && letter != '.' && letter != '-') {
                plain.append(Character.toLowerCase(letter));
            }
        }
        return plain.toString();
    }

    /**
     * The number of letters to add, delete, change or swap with their neighbour (optimal string alignment distance).
     */
    private static int distance(String from, String to) {
        int[][] distance = new int[from.length() + 1][to.length() + 1];
        for (int i = 0; i <= from.length(); i++) {
            for (int j = 0; j <= to.length(); j++) {
                distance[i][j] = i == 0 ? j : j == 0 ? i : step(distance, i, j, from, to);
            }
        }
        return distance[from.length()][to.length()];
    }

    private static int step(int[][] distance, int i, int j, String from, String to) {
        boolean same = from.charAt(i - 1) == to.charAt(j - 1);
        int least =
                Math.min(distance[i - 1][j - 1] + (same ? 0 : 1), Math.min(distance[i - 1][j], distance[i][j - 1]) + 1);
        boolean swapped =
                i > 1 && j > 1 && from.charAt(i - 1) == to.charAt(j - 2) && from.charAt(i - 2) == to.charAt(j - 1);
        return swapped ? Math.min(least, distance[i - 2][j - 2] + 1) : least;
    }
}
