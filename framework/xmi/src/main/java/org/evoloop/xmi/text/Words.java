package org.evoloop.xmi.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.statechart.Arc;

/** Texts for a diagram of Mermaid. A letter is escaped only where Mermaid or this package would take it for a sign. */
final class Words {
    /** Words that begin statements, or that Mermaid uses itself. */
    private static final Set<String> RESERVED = Set.of(
            "state",
            "note",
            "end",
            "class",
            "classdef",
            "style",
            "click",
            "direction",
            "default",
            "as",
            "fork",
            "join",
            "choice",
            "scale",
            "hide",
            "acctitle",
            "accdescr",
            "title",
            "statediagram",
            "root",
            "graph",
            "subgraph");

    private static final Pattern ID = Pattern.compile("\\p{L}[\\p{L}\\p{N}_]*");
    /** What Mermaid takes for the end of a statement, a state's contents, a comment, a tag, an entity or a label. */
    private static final Pattern ALWAYS =
            Pattern.compile("[;{}\\p{Cntrl}]|%%|<(?=[\\p{L}/!?])|&(?=[#\\w])|::+|\\\\(?=[,;/\\[\\]{}()\"\\\\nN])");

    private static final Pattern SIGNS = Pattern.compile("[,/\\[\\]()\":«]");

    /** The first letter of a word that begins what a state does, or is what defers an event. */
    private static final Pattern BEHAVIOR = Pattern.compile(
            "(?i)^(?:e(?=ntry\\s*[/:])|e(?=xit\\s*[/:])|d(?=o\\s*[/:])|d(?=efer\\s*[/:]))|(?<=/ )d(?=efer$)");

    /** Between the texts of several guards, each in its own brackets. */
    static final String BETWEEN_GUARDS = "] [";

    private Words() {}

    static boolean isId(String name) {
        return ID.matcher(name).matches()
                && !RESERVED.contains(name.toLowerCase(Locale.ROOT))
                && !name.matches("root_(start|end)\\d*");
    }

    /** A name in quotation marks. */
    static String name(String name) {
        return escape(ALWAYS, name).replace("\"", "#quot;");
    }

    static String trigger(String event) {
        return shortest(event, raw -> isAlone(raw, List.of(event), List.of(), List.of()));
    }

    static String effect(String effect) {
        return shortest(effect, raw -> isAlone("/ " + raw, List.of(), List.of(), List.of(effect)));
    }

    private static String guard(String guard) {
        return shortest(guard, raw -> isAlone("[" + raw + "]", List.of(), List.of(guard), List.of()));
    }

    /** The transition's label; empty if it has none. */
    static String label(Arc arc) {
        List<String> parts = new ArrayList<>();
        List<String> triggers = arc.triggers().stream()
                .map(event -> arc.keywords(event) + trigger(event))
                .toList();
        parts.add(String.join(", ", triggers));
        if (!arc.guard().isEmpty()) {
            // The guards of a flat machine's transition are several, each in its own brackets.
            parts.add(Arrays.stream(arc.guard().split(Pattern.quote(BETWEEN_GUARDS), -1))
                    .map(Words::guard)
                    .collect(Collectors.joining(BETWEEN_GUARDS, "[", "]")));
        }
        if (!arc.effects().isEmpty()) {
            parts.add("/ "
                    + String.join(
                            ", ", arc.effects().stream().map(Words::effect).toList()));
        }
        parts.add(arc.kind() == Arc.Kind.LOCAL ? Label.LOCAL : "");
        return String.join(" ", parts.stream().filter(part -> !part.isEmpty()).toList());
    }

    /** An internal transition in the text of its state, where some words would mean something else. */
    static String inState(Arc internal) {
        String text = label(internal) + (internal.effects().isEmpty() ? " /" : "");
        return BEHAVIOR.matcher(text)
                .replaceAll(word -> "#" + (int) word.group().charAt(0) + ";");
    }

    private static boolean isAlone(String label, List<String> triggers, List<String> guards, List<String> effects) {
        try {
            return Label.parse(label, 1, Syntax.MERMAID).equals(new Label(triggers, guards, effects, false));
        } catch (Refusal needsEscapes) {
            return false;
        }
    }

    private static String shortest(String text, Predicate<String> readsBack) {
        String raw = escape(ALWAYS, text);
        return readsBack.test(raw) ? raw : escape(SIGNS, raw);
    }

    private static String escape(Pattern letters, String text) {
        Matcher found = letters.matcher(text);
        return found.replaceAll(match -> {
            StringBuilder escaped = new StringBuilder();
            match.group()
                    .codePoints()
                    .forEach(point -> escaped.append('#').append(point).append(';'));
            return escaped.toString();
        });
    }
}
