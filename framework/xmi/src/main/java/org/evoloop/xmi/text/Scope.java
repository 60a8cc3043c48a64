package org.evoloop.xmi.text;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.jspecify.annotations.Nullable;

/** A region: of the diagram, or of a state. {@code [*]}, {@code [H]} and {@code [H*]} in it belong to it. */
final class Scope {
    /** Begins the key of an initial pseudostate. */
    static final String INITIAL = "[*] of ";

    private final @Nullable TextState owner;
    private final String path;
    private final int line;
    private final List<Vertex> pseudostates = new ArrayList<>();
    private boolean initial;
    private boolean end;

    /** @param owner null for the diagram's own regions */
    Scope(@Nullable TextState owner, int number, int line) {
        this.owner = owner;
        this.path = path(owner == null ? "" : owner.id(), number);
        this.line = line;
    }

    @Nullable
    TextState owner() {
        return owner;
    }

    Place place() {
        return new Place("", line);
    }

    /** For messages. */
    String label() {
        return owner == null ? "the diagram itself" : owner.id();
    }

    /** The key of its initial pseudostate, which is drawn in this line. */
    String initial(int at) {
        String key = INITIAL + path;
        if (!initial) {
            pseudostates.add(0, new Pseudostate(key, "", new Place("", at), Kind.INITIAL));
            initial = true;
        }
        return key;
    }

    /** The key of its final state, which is drawn in this line. */
    String end(int at) {
        String key = "[*] ends " + path;
        if (!end) {
            pseudostates.add(new FinalState(key, "", new Place("", at)));
            end = true;
        }
        return key;
    }

    private static String path(String state, int number) {
        return state + "/" + number;
    }

    /** The key of the history of a state's region. */
    static String history(boolean deep, String state, int number) {
        return (deep ? "[H*] of " : "[H] of ") + path(state, number);
    }

    /** The key of its history, which is drawn in this line. */
    String history(boolean deep, int at) {
        String key = (deep ? "[H*] of " : "[H] of ") + path;
        if (pseudostates.stream().noneMatch(known -> known.key().equals(key))) {
            Kind kind = deep ? Kind.DEEP_HISTORY : Kind.SHALLOW_HISTORY;
            pseudostates.add(new Pseudostate(key, "", new Place("", at), kind));
        }
        return key;
    }

    /** The vertices that have no id. */
    List<Vertex> pseudostates() {
        return pseudostates;
    }

    /** Whether it, or a region around it, is one of several of a state. */
    boolean isBesideOthers() {
        Scope around = this;
        while (around != null) {
            TextState state = around.owner;
            if (state != null && state.regions.size() > 1) {
                return true;
            }
            around = state == null ? null : state.home();
        }
        return false;
    }

    /** Whether the other region is this one, or inside it at any depth. */
    boolean encloses(Scope other) {
        Scope outer = other;
        while (outer != null && outer != this) {
            TextState state = outer.owner;
            outer = state == null ? null : state.home();
        }
        return outer == this;
    }
}
