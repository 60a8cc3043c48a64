package org.evoloop.xmi.text;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statechart.Place;
import org.evoloop.xmi.dialect.Problems;

/** Reads the text in a state: what it does, what it defers, its internal transitions and keywords, or a description. */
final class Behaviors {
    private static final Pattern BEHAVIOR = Pattern.compile("(?i)\\s*+(entry|exit|do)\\s*+[/:](.*)", Pattern.DOTALL);
    /** One or several keywords in guillemets, and nothing else. */
    private static final Pattern KEYWORDS = Pattern.compile("(?:(?:«[^«»]*+»|<<[^<>]*+>>)\\s*+)++");

    private static final Pattern KEYWORD = Pattern.compile("\\s*+(?:«|<<)");

    private static final Pattern DEFER = Pattern.compile("(?i)defer\\s*+[/:](.*)", Pattern.DOTALL);
    private static final Pattern IS_DEFERRED = Pattern.compile("(?i)([^/]*)/\\s*+defer", Pattern.DOTALL);

    private static final String BEHAVIORS = "entry / EFFECT, exit / EFFECT or EVENT / EFFECT";

    private final Syntax syntax;
    private final Problems problems;

    Behaviors(Syntax syntax, Problems problems) {
        this.syntax = syntax;
        this.problems = problems;
    }

    /**
     * Reads one line of a state's text.
     *
     * @throws Refusal if it has no meaning
     */
    void read(TextState state, String text, int line, int column) throws Refusal {
        Matcher behavior = BEHAVIOR.matcher(text);
        String deferred = deferred(text.strip());
        if (behavior.matches()) {
            List<String> texts =
                    Label.parse("/" + behavior.group(2), column, syntax).effects();
            switch (behavior.group(1).toLowerCase(Locale.ROOT)) {
                case "entry" -> state.entry.addAll(texts);
                case "exit" -> state.exit.addAll(texts);
                default -> state.activities.addAll(texts);
            }
        } else if (KEYWORDS.matcher(text.strip()).matches()) {
            state.keywords.add(text.strip());
        } else if (!deferred.isEmpty()) {
            state.deferred.addAll(Label.parse(deferred, column, syntax).triggers());
        } else if (text.indexOf('/') >= 0) {
            noteSlash(text, line, column);
            internal(state, Label.parse(text, column, syntax), line, column);
        } else if (KEYWORD.matcher(text).lookingAt()) {
            throw new Refusal(
                    column, "a keyword ends with » or >> and has nothing beside it; write it in its own line");
        } else if (!text.isBlank()) {
            problems.note(
                    line,
                    "column " + column + ": " + Problems.quote(text.strip()) + " describes state '" + state.id()
                            + "' and does nothing; write "
                            + DeviceUse.parse(text).map(DeviceUse::keywords).orElse(BEHAVIORS + " for what it does"));
        }
    }

    /** Notes how a slash was understood that could be a letter. */
    void noteSlash(String label, int line, int column) {
        int slash = Label.doubtfulSlash(label, syntax);
        if (slash >= 0) {
            problems.note(
                    line,
                    "column " + (column + slash) + ": "
                            + Problems.quote(label.substring(slash + 1)
                                    .replace(Label.BREAK, ' ')
                                    .strip())
                            + " behind '/' is what is done; write blanks around the '/' if it is, or \\/ for the letter");
        }
    }

    /** The events that are deferred, {@code defer / e} or {@code e / defer}; empty if this is something else. */
    private static String deferred(String text) {
        Matcher defer = DEFER.matcher(text);
        Matcher isDeferred = IS_DEFERRED.matcher(text);
        return defer.matches() ? defer.group(1) : isDeferred.matches() ? isDeferred.group(1) : "";
    }

    private void internal(TextState state, Label label, int line, int column) throws Refusal {
        if (label.triggers().isEmpty()) {
            throw new Refusal(column, "an internal transition needs an event; write EVENT [guard] / effect");
        }
        state.internal.add(new Arc(
                new Place("", line),
                state.id(),
                state.id(),
                label.triggers(),
                String.join(Words.BETWEEN_GUARDS, label.guards()),
                label.effects(),
                Arc.Kind.INTERNAL));
    }
}
