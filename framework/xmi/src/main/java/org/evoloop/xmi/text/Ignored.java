package org.evoloop.xmi.text;

import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.xmi.dialect.Problems;
import org.jspecify.annotations.Nullable;

/**
 * Recognises lines that say nothing about behavior: comments, notes, colors and layout. Such a block may have many
 * lines, which are then ignored up to its end.
 */
final class Ignored {
    private static final Set<String> MERMAID_WORDS = Set.of(
            "direction", "classDef", "class", "style", "click", "accTitle", "accDescr", "scale", "hide", "title");
    private static final Set<String> PLANTUML_WORDS = Set.of(
            "hide",
            "show",
            "scale",
            "title",
            "header",
            "footer",
            "legend",
            "caption",
            "left",
            "top",
            "center",
            "right",
            "skinparam",
            "skin",
            "allow_mixing",
            "mainframe",
            "sprite",
            "url",
            "remove",
            "page");
    /** The PlantUML statements that end with a line {@code end WORD}, unless the text follows at once. */
    private static final Pattern BLOCK =
            Pattern.compile("(?i)\\s*(?:(?:left|right|center)\\s+)?(title|header|footer|legend|caption)"
                    + "(?:\\s+(?:left|right|center|top|bottom))*\\s*");
    /** What may follow the place of a note, beside its text: a color, a link, and the name of a state. */
    private static final Pattern BESIDE_TEXT = Pattern.compile("#\\S*|\\[\\[.*?]]|\\bof\\s+\"[^\"]*\"");
    /** What the preprocessor does that changes no state. */
    private static final Pattern HARMLESS = Pattern.compile("!(theme|pragma|assume)\\b.*");
    /** A dotted line, which connects a note. */
    private static final Pattern DOTTED = Pattern.compile("\\w+\\s*\\.{2,}\\s*\\w+");

    private final Syntax syntax;
    private final Problems problems;
    /** Matches the last line of the block that has begun; null outside of one. */
    private @Nullable Pattern end;

    private String what = "";
    private int begun;

    Ignored(Syntax syntax, Problems problems) {
        this.syntax = syntax;
        this.problems = problems;
    }

    /** Whether the line is ignored; then the cursor is at its end, or behind the comment. */
    boolean takes(Cursor line) {
        if (end != null) {
            if (end.matcher(line.rest()).find()) {
                end = null;
            }
            return true;
        }
        return syntax == Syntax.MERMAID ? mermaid(line) : plantUml(line);
    }

    /** Reports a block that has no end, after the last line. */
    void finish() {
        if (end != null) {
            problems.add(begun, "column 1: " + what + " has no end; write one behind it");
        }
    }

    private boolean mermaid(Cursor line) {
        if (line.isAt("%%{") && !line.comesLater("}%%")) {
            return begin(line, "the directive %%{", "\\}%%");
        }
        if (line.isAt("%%")) {
            return all(line);
        }
        if (isStatement(line, "note")) {
            return note(line);
        }
        if (line.isAt("accDescr") && line.ahead().matches("accDescr\\s*\\{[^}]*")) {
            return begin(line, "accDescr {", "\\}");
        }
        boolean ignored = line.isAt("accTitle:")
                || line.isAt("accDescr:")
                || MERMAID_WORDS.stream().anyMatch(word -> isStatement(line, word));
        return ignored && all(line);
    }

    private boolean plantUml(Cursor line) {
        if (line.isAt("/'")) {
            if (line.comesLater("'/")) {
                line.upTo("'/");
                return true;
            }
            return begin(line, "the comment /'", "'/");
        }
        if (line.isAt("'") || HARMLESS.matcher(line.ahead()).matches()) {
            return all(line);
        }
        if (isStatement(line, "note") || line.isAt("floating note")) {
            return note(line);
        }
        if (line.isAt("<style>")) {
            return line.comesLater("</style>") ? all(line) : begin(line, "<style>", "(?i)</style>");
        }
        if (isStatement(line, "skinparam") && line.comesLater("{") && !line.comesLater("}")) {
            return begin(line, "skinparam", "^\\s*\\}");
        }
        Matcher block = BLOCK.matcher(line.ahead());
        if (block.matches()) {
            return begin(line, block.group(1), "(?i)^\\s*end\\s*" + block.group(1));
        }
        boolean ignored = DOTTED.matcher(line.ahead().strip()).matches()
                || PLANTUML_WORDS.stream().anyMatch(word -> isStatement(line, word));
        return ignored && all(line);
    }

    /** A note in one line has its text behind a colon or in quotation marks. */
    private boolean note(Cursor line) {
        String text = BESIDE_TEXT.matcher(line.ahead()).replaceAll("");
        boolean inOneLine = text.contains(":") || text.contains("\"");
        return inOneLine ? all(line) : begin(line, "the note", "(?i)^\\s*end\\s*note\\s*$");
    }

    private static boolean all(Cursor line) {
        line.rest();
        return true;
    }

    private boolean begin(Cursor line, String construct, String last) {
        begun = line.line();
        what = construct;
        end = Pattern.compile(last);
        return all(line);
    }

    /** Whether the line begins with the word, which is not a state in a transition or before its description. */
    private static boolean isStatement(Cursor line, String word) {
        int column = line.column();
        boolean here = line.takeWord(word) && line.hasMore() && !line.isAt("-") && !line.isAt("<-") && !line.isAt(":");
        line.backTo(column);
        return here;
    }
}
