package org.evoloop.models.diagram;

import java.util.Locale;
import org.evoloop.models.diagram.Diagram.Tone;

/** The colours of each tone, and its text in the legend. */
enum Palette {
    PLAIN(Tone.PLAIN, "#333", "#ffffee", "1.5", "", "kept"),
    ADDED(Tone.ADDED, "#0b62a8", "#e4f0fb", "2", "", "added by the new model"),
    REROUTED(Tone.REROUTED, "#a85b00", "#fff1dc", "2", "7 4", "rerouted: where it leads now"),
    FORMER(Tone.FORMER, "#aaa", "#f6f6f6", "1.2", "", "rerouted: where it led before"),
    REMOVED(Tone.REMOVED, "#b3261e", "#fdecea", "1.5", "", "removed"),
    MARKED(Tone.MARKED, "#a3159a", "#fbe6fa", "3", "", "on the path of the counterexample"),
    SENDING(Tone.SENDING, "#a85b00", "#fff1dc", "2", "", "kept by sending events"),
    WAITING(Tone.WAITING, "#0b62a8", "#e4f0fb", "2", "", "the swap waits until it is left"),
    STUCK(Tone.STUCK, "#b3261e", "#fdecea", "3", "", "no swap is possible in it"),
    OTHERWISE(Tone.OTHERWISE, "#0b62a8", "#e4f0fb", "2", "", "decided differently from the recording"),
    BROKEN(Tone.BROKEN, "#b3261e", "#fdecea", "3", "", "a property is broken");

    private final Tone tone;
    private final String line;
    private final String fill;
    private final String strokeWidth;
    private final String dashes;
    private final String meaning;

    Palette(Tone tone, String line, String fill, String strokeWidth, String dashes, String meaning) {
        this.tone = tone;
        this.line = line;
        this.fill = fill;
        this.strokeWidth = strokeWidth;
        this.dashes = dashes;
        this.meaning = meaning;
    }

    static Palette of(Tone tone) {
        return valueOf(tone.name());
    }

    /** The CSS class of its elements. */
    String cssClass() {
        return tone.name().toLowerCase(Locale.ROOT);
    }

    /** The text in the legend. */
    String meaning() {
        return meaning;
    }

    String css() {
        String dashed = dashes.isEmpty() ? "" : "; stroke-dasharray: " + dashes;
        return """
                .%1$s .box { stroke: %2$s; fill: %3$s; stroke-width: %4$s }
                .%1$s .line { stroke: %2$s; stroke-width: %4$s%5$s }
                .%1$s .way { marker-end: url(#arrow-%1$s) }
                .%1$s .solid { stroke: %2$s; fill: %2$s }
                .%1$s text { fill: %2$s }
                """.formatted(cssClass(), line, fill, strokeWidth, dashed);
    }

    /** The SVG marker of its arrowheads, which are open as in UML. */
    String marker() {
        return """
                <marker id="arrow-%s" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="10" markerHeight="10" \
                markerUnits="userSpaceOnUse" orient="auto">\
                <path d="M0 1 L9 5 L0 9" fill="none" stroke="%s" stroke-width="1.6"/></marker>
                """.formatted(cssClass(), line);
    }
}
