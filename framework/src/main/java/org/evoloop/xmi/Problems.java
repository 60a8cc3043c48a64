package org.evoloop.xmi;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/** What is wrong with one machine, one line each; a machine with thousands of problems gets the first of them. */
final class Problems {
    private static final int LISTED = 100;
    private static final int QUOTED_CHARACTERS = 120;

    private final List<Problem> listed = new ArrayList<>();
    private int unlisted;

    private record Problem(int line, String text) {}

    Problems() {}

    Problems(Problems earlier) {
        listed.addAll(earlier.listed);
        unlisted = earlier.unlisted;
    }

    /** @param line counted from 1 */
    void add(int line, String text) {
        if (listed.size() < LISTED) {
            listed.add(new Problem(line, "line " + line + ": " + text));
        } else {
            unlisted++;
        }
    }

    /** A problem whose text says by itself where it stands. */
    void add(String text) {
        if (listed.size() < LISTED) {
            listed.add(new Problem(Integer.MAX_VALUE, text));
        } else {
            unlisted++;
        }
    }

    boolean isEmpty() {
        return listed.isEmpty();
    }

    int count() {
        return listed.size() + unlisted;
    }

    /** One problem a line, in the file's order. */
    @Override
    public String toString() {
        String lines = listed.stream()
                .sorted(Comparator.comparingInt(Problem::line))
                .map(problem -> "\n  " + problem.text())
                .collect(Collectors.joining());
        return unlisted == 0 ? lines : lines + "\n  and " + unlisted + " more";
    }

    /** The text in quotes, cut where it would make a message unreadable. */
    static String quote(String text) {
        return text.length() <= QUOTED_CHARACTERS
                ? "'" + text + "'"
                : "'" + text.substring(0, QUOTED_CHARACTERS) + "...'";
    }
}
