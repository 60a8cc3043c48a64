package org.evoloop.xmi.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.xmi.dialect.Problems;
import org.jspecify.annotations.Nullable;

/**
 * Whatever has an id in a diagram: a state, or a choice, fork and the like.
 *
 * <p>An id belongs to one region, and the languages differ in which: in Mermaid to the last region of a state that
 * names it, in PlantUML to the first one that declares it, or to the first that names it if none declares it.
 */
final class TextState {
    private final String id;
    private final int line;
    private final Map<Scope, Mention> mentions = new LinkedHashMap<>();
    private @Nullable Scope home;
    /** The first region that declares or describes it. */
    private @Nullable Scope described;

    private String name;
    /** Null for a state. */
    private @Nullable Kind kind;

    private boolean end;
    /** Such as {@code «device On»}. */
    final List<String> keywords = new ArrayList<>();

    final List<Scope> regions = new ArrayList<>();
    final List<String> entry = new ArrayList<>();
    final List<String> exit = new ArrayList<>();
    final List<String> activities = new ArrayList<>();
    final List<String> deferred = new ArrayList<>();
    final List<Arc> internal = new ArrayList<>();

    /** How a line names it, the weakest first. */
    enum Naming {
        /** At the end of an arrow. */
        LINKED,
        /** {@code id : text}. */
        DESCRIBED,
        /** {@code state id}. */
        DECLARED
    }

    private record Mention(int line, int column, Naming naming) {
        Mention and(Mention later) {
            return new Mention(line, column, naming.compareTo(later.naming) < 0 ? later.naming : naming);
        }
    }

    TextState(String id, int line) {
        this.id = id;
        this.name = id;
        this.line = line;
    }

    String id() {
        return id;
    }

    Place place() {
        return new Place("", line);
    }

    String name() {
        return name;
    }

    /** The name, preceded by the keywords in guillemets that are written elsewhere. */
    String marked() {
        return keywords.isEmpty() ? name : String.join(" ", keywords) + " " + name;
    }

    void rename(String shown) {
        name = shown;
    }

    @Nullable
    Kind kind() {
        return kind;
    }

    void become(Kind pseudostate) {
        kind = pseudostate;
    }

    boolean isEnd() {
        return end;
    }

    void becomeEnd() {
        end = true;
    }

    /** Whether it does something, or contains something. */
    boolean hasContents() {
        return !(regions.isEmpty()
                && entry.isEmpty()
                && exit.isEmpty()
                && activities.isEmpty()
                && deferred.isEmpty()
                && internal.isEmpty());
    }

    /** The region that it belongs to. */
    @Nullable
    Scope home() {
        return home;
    }

    void mention(Scope scope, int at, int column, Naming naming, Syntax syntax) {
        boolean declared = mentions.values().stream().anyMatch(mention -> mention.naming() == Naming.DECLARED);
        boolean moves = syntax == Syntax.MERMAID ? scope.owner() != null : naming == Naming.DECLARED && !declared;
        mentions.merge(scope, new Mention(at, column, naming), Mention::and);
        if (home == null || moves) {
            home = scope;
        }
        if (described == null && naming != Naming.LINKED) {
            described = scope;
        }
    }

    /** Whether its region is inside itself. */
    boolean isInItself() {
        Scope outer = home;
        for (int depth = 0; outer != null && depth <= TextTree.MAX_DEPTH; depth++) {
            TextState owner = outer.owner();
            if (owner == this) {
                return true;
            }
            outer = owner == null ? null : owner.home;
        }
        return outer != null;
    }

    /** Reports a mention in a region that is beside its own, and a region that is uncertain. */
    void check(Syntax syntax, Problems problems) {
        Scope own = home;
        if (own == null || mentions.size() == 1) {
            return;
        }
        Mention first = mentions.get(own);
        Scope other = described;
        Mention text = mentions.get(other);
        if (syntax == Syntax.PLANTUML && other != null && other != own && text != null && first != null) {
            problems.add(
                    text.line(),
                    "column " + text.column() + ": '" + id + "' is described in " + where(other)
                            + " here, and belongs to "
                            + where(own) + " by line " + first.line()
                            + "; versions of PlantUML draw it in the one or the"
                            + " other, so write both in one place");
            return;
        }
        mentions.forEach((scope, mention) -> {
            if (first != null
                    && !scope.encloses(own)
                    && !own.encloses(scope)
                    && !(syntax == Syntax.PLANTUML && isOnlyLinked(scope, mention, own, first))) {
                problems.add(
                        mention.line(),
                        "column " + mention.column() + ": '" + id + "' is named in " + where(scope) + " here, and in "
                                + where(own) + " in line " + first.line() + ", but one id is one state; rename one of"
                                + " them, or write the transition outside of both");
            }
        });
    }

    /** Whether an arrow in one state ends at this one, which is declared in another; PlantUML refuses that in regions. */
    private static boolean isOnlyLinked(Scope scope, Mention mention, Scope own, Mention first) {
        return first.naming() == Naming.DECLARED
                && mention.naming() == Naming.LINKED
                && !scope.isBesideOthers()
                && !own.isBesideOthers();
    }

    private static String where(Scope scope) {
        TextState owner = scope.owner();
        return owner != null && owner.regions.size() > 1
                ? "region " + (owner.regions.indexOf(scope) + 1) + " of " + scope.label()
                : scope.label();
    }
}
