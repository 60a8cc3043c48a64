package org.evoloop.xmi.dialect;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.statechart.Place;

/** The problems of one machine, one line each; of thousands, only the first are listed. */
public final class Problems {
    private static final int LISTED = 100;
    private static final int QUOTED_CHARACTERS = 120;

    private final List<Problem> listed = new ArrayList<>();
    private int unlisted;
    private final Set<Problem> notes = new LinkedHashSet<>();

    private record Problem(Place place, String text) {
        /** Problems without a line come last. */
        int order() {
            return place.line() > 0 ? place.line() : Integer.MAX_VALUE;
        }

        @Override
        public String toString() {
            return place.equals(Place.NONE) ? text : place + ": " + text;
        }
    }

    /** Adds all problems and notes found earlier. */
    public void addAll(Problems earlier) {
        earlier.listed.forEach(problem -> add(problem.place(), problem.text()));
        unlisted += earlier.unlisted;
        notes.addAll(earlier.notes);
    }

    /**
     * Adds a problem, unless it is already there.
     *
     * @param line counted from 1; 0 if it has no line
     * @param text the problem, with kind, name and id of the element, and how to fix it
     */
    public void add(int line, String text) {
        add(new Place("", line), text);
    }

    /**
     * Adds a problem, unless it is already there.
     *
     * @param place of which file and line are used
     * @param text as above
     */
    public void add(Place place, String text) {
        Problem problem = new Problem(new Place(place.file(), "", place.line()), text);
        if (listed.contains(problem)) {
            return;
        }
        if (listed.size() < LISTED) {
            listed.add(problem);
        } else {
            unlisted++;
        }
    }

    /**
     * Adds a note for the author about something readable: how it was interpreted, or that it has no meaning.
     *
     * @param line as in {@link #add}
     * @param text as in {@link #add}
     */
    public void note(int line, String text) {
        note(new Place("", line), text);
    }

    /** The same for a place, of which file and line are used. */
    public void note(Place place, String text) {
        if (notes.size() < LISTED) {
            notes.add(new Problem(new Place(place.file(), "", place.line()), text));
        }
    }

    /** The name of a state. If it has none, its id; that is noted. */
    public String nameOrId(String name, Place place) {
        String id = place.id();
        if (!name.isEmpty() || id.isEmpty()) {
            return name;
        }
        note(place, "state without a name is called by its id, " + quote(id) + "; give it a name");
        return id;
    }

    /** The notes, in the file's order. */
    public List<String> notes() {
        return notes.stream()
                .sorted(Comparator.comparingInt(Problem::order))
                .map(Problem::toString)
                .toList();
    }

    /** Whether there are no problems. */
    public boolean isEmpty() {
        return listed.isEmpty();
    }

    /** The number of problems, including those not listed. */
    public int count() {
        return listed.size() + unlisted;
    }

    /** All problems, one per line, in the file's order. */
    @Override
    public String toString() {
        String lines = listed.stream()
                .sorted(Comparator.comparingInt(Problem::order))
                .map(problem -> "\n  " + problem)
                .collect(Collectors.joining());
        return unlisted == 0 ? lines : lines + "\n  and " + unlisted + " more";
    }

    /** The text in quotes, truncated if it is too long for a message. */
    public static String quote(String text) {
        return text.length() <= QUOTED_CHARACTERS
                ? "'" + text + "'"
                : "'" + text.substring(0, QUOTED_CHARACTERS) + "...'";
    }

    /** The name and id, for messages. */
    public static String label(String name, String id) {
        return quote(name) + " (id " + quote(id) + ")";
    }
}
