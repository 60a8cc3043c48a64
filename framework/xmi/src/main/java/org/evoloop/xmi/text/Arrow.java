package org.evoloop.xmi.text;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.xmi.dialect.Problems;

/** The arrow between two ids. */
enum Arrow {
    THERE,
    BACK,
    /** Only for the layout. */
    HIDDEN;

    /** With a direction, a style, and a circle or a cross at its ends, all of which are for the layout. */
    private static final Pattern PLANTUML = Pattern.compile(
            "(?:x(?=-)|o(?=<))?<?-+(?:\\[[^\\]]*+\\])?(?:left|right|up|down|le|ri|do|[lrud])?(?:\\[[^\\]]*+\\])?-*>?(?:[xo](?=\\s))?");

    /**
     * Moves behind the arrow that is here.
     *
     * @throws Refusal if none is
     */
    static Arrow read(Cursor line, Syntax syntax) throws Refusal {
        int column = line.column();
        if (syntax == Syntax.MERMAID) {
            if (line.take("-->")) {
                return THERE;
            }
            throw line.isAt("->")
                    ? new Refusal(column, "Mermaid's arrow is -->, and this is ->; write A --> B")
                    : none(line, column);
        }
        Matcher found = PLANTUML.matcher(line.ahead());
        String arrow = found.lookingAt() ? found.group() : "";
        if (arrow.contains("<") == arrow.contains(">")) {
            throw none(line, column);
        }
        line.take(arrow);
        return arrow.contains("hidden") ? HIDDEN : arrow.contains("<") ? BACK : THERE;
    }

    private static Refusal none(Cursor line, int column) {
        return new Refusal(
                column,
                Problems.quote(line.ahead().strip()) + " is no arrow; write A --> B, or A : text for a description");
    }
}
