package org.evoloop.xmi.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.text.Statement.Mark;
import org.evoloop.xmi.text.TextState.Naming;
import org.jspecify.annotations.Nullable;

/**
 * Reads the statements of a diagram:
 *
 * <pre>{@code
 * statement = "state" name [kind] [":" text] ["{"]  |  end arrow end [":" label]  |  id ":" text  |  id
 *           | "}"  |  "--"  |  what Ignored takes
 * name      = id  |  '"' text '"' "as" id  |  id "as" '"' text '"'
 * end       = id  |  "[*]"  |  "[H]"  |  "[H*]"  |  id "[H]"  |  id "[H*]"
 * }</pre>
 *
 * <p>Threading: for one thread.
 */
final class Statements {
    private static final Map<String, Kind> SHARED_KINDS =
            Map.of("choice", Kind.CHOICE, "fork", Kind.FORK, "join", Kind.JOIN);
    private static final Map<String, Kind> PLANTUML_KINDS = Map.of(
            "start", Kind.INITIAL,
            "history", Kind.SHALLOW_HISTORY,
            "history*", Kind.DEEP_HISTORY,
            "entrypoint", Kind.ENTRY_POINT,
            "exitpoint", Kind.EXIT_POINT);
    private static final Pattern SEPARATOR = Pattern.compile("(--+|\\|\\|)\\s*");
    /** Nobody writes longer ones, and reading them may take time quadratic in their length. */
    private static final int LONGEST_LINE = 4_000;

    /** A colon and more that PlantUML takes for a part of the id before it, at the begin of an arrow. */
    private static final Pattern COLON_OF_SOURCE = Pattern.compile(":[\\p{L}\\p{N}_.:]*+(?=\\s*+(?:x?-+[^-]*>|o?<-))");
    /** The same at its end, where only a colon that a blank or a sign follows begins the label. */
    private static final Pattern COLON_OF_TARGET =
            Pattern.compile(":[\\p{L}\\p{N}_.]*+(?::[\\p{L}\\p{N}_.:]*+|(?=\\s*+(?:$|[#:]|<<|\\[\\[)))");
    /** What PlantUML removes at the end of a line. */
    private static final Pattern COMMENT_BEHIND = Pattern.compile("\\s/'(?:(?!'/).)*'/\\s*$");

    private static final Pattern NEW_PAGE = Pattern.compile("(?i)newpage\\b.*");

    /** A line break in a label. */
    private static final Pattern BREAK = Pattern.compile("(?i)<br\\s*/?>|\\\\n");

    private final TextBlock block;
    private final Syntax syntax;
    private final Problems problems;
    private final TextTree tree;
    private final Ignored ignored;
    private final Behaviors behaviors;
    private final List<Statement> read = new ArrayList<>();

    Statements(TextBlock block, Problems problems) {
        this.block = block;
        this.syntax = block.syntax();
        this.problems = problems;
        this.tree = new TextTree(block.file(), syntax, block.line(), problems);
        this.ignored = new Ignored(syntax, problems);
        this.behaviors = new Behaviors(syntax, problems);
    }

    Statechart chart(String title) {
        int number = block.line();
        String begun = "";
        for (String next : block.lines()) {
            number++;
            String text = begun + next;
            boolean isLast = number == block.line() + block.lines().size();
            if (syntax == Syntax.PLANTUML && !isLast && text.endsWith("\\") && !text.endsWith("\\\\")) {
                // PlantUML continues it with the next line.
                begun = text.substring(0, text.length() - 1);
                continue;
            }
            begun = "";
            if (text.length() > LONGEST_LINE) {
                problems.add(number, "the line has " + text.length() + " letters; write shorter ones");
                continue;
            }
            Cursor line = new Cursor(
                    syntax == Syntax.PLANTUML ? COMMENT_BEHIND.matcher(text).replaceFirst("") : text, number);
            try {
                while (line.hasMore()) {
                    if (!ignored.takes(line)) {
                        statement(line);
                    }
                }
            } catch (Refusal refusal) {
                problems.add(number, refusal.text());
                openAllTheSame(text, number);
            }
        }
        ignored.finish();
        return tree.chart(title);
    }

    /** The statements that have been understood, in their order. */
    List<Statement> read() {
        return read;
    }

    /** The states with their ids. */
    TextTree tree() {
        return tree;
    }

    private void read(
            Cursor line, Statement.Kind kind, Scope scope, @Nullable Mark first, @Nullable Mark second, int text) {
        read.add(new Statement(line.line(), kind, scope, first, second, text, null));
    }

    /** A refused state with contents is closed as well, and that is no second mistake. */
    private void openAllTheSame(String text, int line) {
        if (text.strip().endsWith("{") && text.strip().startsWith("state")) {
            tree.open(tree.state("refused in line " + line, line, 1, Naming.DECLARED), line, 1);
        }
    }

    private void statement(Cursor line) throws Refusal {
        int column = line.column();
        requireOnePage(line);
        if (SEPARATOR.matcher(line.ahead()).matches() && (syntax == Syntax.PLANTUML || !line.isAt("||"))) {
            if (syntax == Syntax.MERMAID && tree.scope().owner() == null) {
                throw new Refusal(column, "Mermaid has regions in states only; write state NAME { before them");
            }
            line.rest();
            read(line, Statement.Kind.SEPARATOR, tree.scope(), null, null, -1);
            tree.separate(line.line());
        } else if (line.take("}")) {
            if (!tree.close()) {
                throw new Refusal(column, "} closes no state; remove it");
            }
            read(line, Statement.Kind.CLOSING, tree.scope(), null, null, -1);
        } else if (isDeclaration(line)) {
            declaration(line);
        } else if (!line.isAt("[") && !syntax.isIdPart(line.letter())) {
            throw notUnderstood(line);
        } else {
            transitionOrText(line);
        }
    }

    /** @throws Refusal if another picture begins here, whose states are not those of this one */
    private void requireOnePage(Cursor line) throws Refusal {
        if (syntax == Syntax.PLANTUML && NEW_PAGE.matcher(line.ahead()).matches()) {
            throw new Refusal(
                    line.column(), "newpage begins another diagram; write each between its own @startuml and @enduml");
        }
    }

    private static boolean isDeclaration(Cursor line) {
        int column = line.column();
        boolean here = line.takeWord("state") && line.hasMore() && !line.isAt("-") && !line.isAt(":");
        if (!here) {
            line.backTo(column);
        }
        return here;
    }

    private Refusal notUnderstood(Cursor line) {
        if (syntax == Syntax.PLANTUML && line.isAt("!")) {
            return new Refusal(
                    line.column(),
                    Problems.quote(line.ahead().strip())
                            + " is for PlantUML's preprocessor, which is not run here; write" + " what it makes of it");
        }
        return new Refusal(
                line.column(),
                Problems.quote(line.ahead().strip()) + " is no statement of a state diagram in " + syntax
                        + "; write A --> B : event [guard] / effect, or remove it");
    }

    private void declaration(Cursor line) throws Refusal {
        int column = line.column();
        String shown = line.take("\"") ? quoted(line, column) : "";
        Mark name = shown.isEmpty() ? null : new Mark(shown, column, column + shown.length());
        line.hasMore();
        boolean quotedOnly = !shown.isEmpty() && !line.takeWord("as");
        if (quotedOnly && syntax == Syntax.MERMAID) {
            throw new Refusal(line.column(), "a name in quotation marks needs an id in Mermaid; write as ID behind it");
        }
        line.hasMore();
        int at = line.column();
        String id = quotedOnly ? shown : id(line);
        TextState state = tree.state(id, line.line(), at, Naming.DECLARED);
        Mark named = quotedOnly ? null : new Mark(id, at - 1, at - 1 + id.length());
        read.add(new Statement(line.line(), Statement.Kind.DECLARATION, tree.scope(), named, null, -1, name));
        if (!shown.isEmpty()) {
            shown(state, shown, line.line(), column);
        }
        while (line.hasMore()) {
            if (line.isAt("<<") || line.isAt("[[")) {
                if (syntax == Syntax.MERMAID && !shown.isEmpty()) {
                    throw new Refusal(line.column(), "Mermaid allows no name before a kind; write state ID <<KIND>>");
                }
                stereotype(state, line);
            } else if (line.isAt(":::") || (syntax == Syntax.PLANTUML && line.isAt("#"))) {
                style(line);
            } else if (syntax == Syntax.PLANTUML && line.takeWord("as")) {
                line.hasMore();
                if (!line.take("\"")) {
                    throw new Refusal(line.column(), "a name is missing; write it in quotation marks");
                }
                shown(state, quoted(line, column), line.line(), column);
            } else if (line.take("{")) {
                read.set(
                        read.size() - 1,
                        new Statement(line.line(), Statement.Kind.OPENING, tree.scope(), named, null, -1, name));
                tree.open(state, line.line(), line.column() - 1);
                return;
            } else if (line.take(":")) {
                text(state, line);
            } else {
                throw new Refusal(
                        line.column(),
                        Problems.quote(line.ahead().strip()) + " behind state '" + id
                                + "' is not understood; write state \"NAME\" as ID, with { for a state with contents");
            }
        }
    }

    /**
     * Reads what is in a state's quotation marks: its name, and in further lines what it does. For a state with contents
     * Mermaid has no other place.
     */
    private void shown(TextState state, String text, int line, int column) throws Refusal {
        StringBuilder name = new StringBuilder();
        boolean behavior = false;
        for (String part : BREAK.split(text, -1)) {
            behavior |= !name.isEmpty() && part.indexOf('/') >= 0;
            if (behavior) {
                behaviors.read(state, part, line, column);
            } else {
                name.append(name.isEmpty() ? "" : " ").append(part.strip());
            }
        }
        state.rename(Escapes.decode(name.toString(), syntax));
    }

    private static String quoted(Cursor line, int column) throws Refusal {
        if (!line.comesLater("\"")) {
            throw new Refusal(column, "the quotation mark is not closed; write another one behind the name");
        }
        String name = line.upTo("\"");
        if (name.isBlank()) {
            throw new Refusal(column, "the name is empty; write one");
        }
        return name;
    }

    private void stereotype(TextState state, Cursor line) throws Refusal {
        int column = line.column();
        boolean brackets = line.isAt("[[");
        line.take(brackets ? "[[" : "<<");
        String word = line.upTo(brackets ? "]]" : ">>").strip();
        String key = word.toLowerCase(java.util.Locale.ROOT);
        Kind kind = SHARED_KINDS.get(key);
        if (kind == null && syntax == Syntax.PLANTUML) {
            kind = PLANTUML_KINDS.get(key);
            if (key.endsWith("pin") || key.startsWith("expansion")) {
                throw new Refusal(column, "<<" + word + ">> has no meaning in a state machine; write <<entryPoint>>");
            }
        }
        if (kind != null) {
            state.become(kind);
        } else if (key.equals("end") && syntax == Syntax.PLANTUML) {
            state.becomeEnd();
        } else if (key.matches("(device|sends)\\s.*")) {
            state.keywords.add("«" + word + "»");
        } else if (syntax == Syntax.MERMAID) {
            throw new Refusal(
                    column,
                    "<<" + word + ">> is not known to Mermaid, which draws a state of that name; it has <<choice>>,"
                            + " <<fork>> and <<join>>, and PlantUML has histories, entry and exit points");
        }
    }

    private void transitionOrText(Cursor line) throws Refusal {
        int column = line.column();
        String id = line.isAt("[") ? "" : id(line);
        if (!id.isEmpty() && !line.isAt("[H")) {
            refuseColon(line, COLON_OF_SOURCE);
            style(line);
            Mark named = new Mark(id, column - 1, column - 1 + id.length());
            if (!line.hasMore() || line.isAt("}")) {
                tree.state(id, line.line(), column, Naming.LINKED);
                read(line, Statement.Kind.DECLARATION, tree.scope(), named, null, -1);
                return;
            }
            if (line.take(":")) {
                read(line, Statement.Kind.DESCRIPTION, tree.scope(), named, null, line.column() - 1);
                text(tree.state(id, line.line(), column, Naming.DESCRIBED), line);
                return;
            }
        }
        line.backTo(column);
        String source = end(line);
        Mark first = mark(line, column);
        style(line);
        Arrow arrow = Arrow.read(line, syntax);
        line.hasMore();
        int there = line.column();
        String target = end(line);
        Mark second = mark(line, there);
        style(line);
        boolean labelled = line.hasMore() && line.take(":");
        if (!labelled && line.hasMore() && !line.isAt("}") && !(syntax == Syntax.MERMAID && line.isAt("%%"))) {
            throw new Refusal(
                    line.column(),
                    Problems.quote(line.ahead().strip()) + " behind the transition is not understood; write a label"
                            + " behind a colon, A --> B : event [guard] / effect");
        }
        boolean back = arrow == Arrow.BACK;
        int text = labelled ? line.column() - 1 : -1;
        read(line, Statement.Kind.ARROW, tree.scope(), back ? second : first, back ? first : second, text);
        Label label = labelled ? label(line) : new Label(List.of(), List.of(), List.of(), false);
        if (arrow == Arrow.HIDDEN) {
            return;
        }
        String from = back ? target : source;
        String to = back ? source : target;
        int at = line.line();
        tree.arc(
                from.isEmpty() ? tree.scope().initial(at) : from,
                to.isEmpty() ? tree.scope().end(at) : to,
                label,
                at);
    }

    /** The end of an arrow that has been read from {@code column} on. */
    private static Mark mark(Cursor line, int column) {
        String end = line.since(column);
        String id = end.replaceFirst("\\[.*", "");
        return new Mark(id, column - 1, id.isEmpty() ? line.column() - 1 : column - 1 + id.length());
    }

    /** The key of the vertex at the end of an arrow; empty for {@code [*]}. */
    private String end(Cursor line) throws Refusal {
        int column = line.column();
        if (line.take("[*]")) {
            return "";
        }
        if (line.isAt("[")) {
            return history(null, line, column);
        }
        TextState state = tree.state(id(line), line.line(), column, Naming.LINKED);
        refuseColon(line, COLON_OF_TARGET);
        return line.isAt("[H") ? history(state, line, line.column()) : state.id();
    }

    /** @param state whose history it is; null for that of the current region */
    private String history(@Nullable TextState state, Cursor line, int column) throws Refusal {
        boolean deep = line.take("[H*]");
        if (!deep && !line.take("[H]")) {
            throw notUnderstood(line);
        }
        if (syntax == Syntax.MERMAID) {
            throw new Refusal(
                    column,
                    "Mermaid has no history and draws a state of that name; write the diagram in PlantUML, which has"
                            + " [H] and [H*]");
        }
        return state == null ? tree.scope().history(deep, line.line()) : tree.history(state, deep, line.line(), column);
    }

    /** Skips the style and the comment behind a state's id. */
    private void style(Cursor line) {
        while (line.hasMore()) {
            if (line.take(":::")) {
                while (Syntax.PLANTUML.isIdPart(line.letter()) || (line.isAt("-") && !line.isAt("--"))) {
                    line.take(String.valueOf(line.letter()));
                }
            } else if (syntax == Syntax.PLANTUML && line.isAt("#")) {
                line.upTo(" ");
            } else if (syntax == Syntax.PLANTUML && line.isAt("<<")) {
                line.upTo(">>");
            } else if (syntax == Syntax.PLANTUML && line.isAt("/'") && line.comesLater("'/")) {
                line.upTo("'/");
            } else {
                return;
            }
        }
    }

    private void refuseColon(Cursor line, Pattern inId) throws Refusal {
        if (syntax == Syntax.PLANTUML && line.isAt(":")) {
            Matcher colon = inId.matcher(line.ahead());
            if (colon.lookingAt()) {
                throw new Refusal(
                        line.column(),
                        "PlantUML takes " + Problems.quote(colon.group())
                                + " for a part of the id; write a blank before" + " the colon of a label");
            }
        }
    }

    private boolean isDash(Cursor line) {
        return syntax == Syntax.MERMAID && line.isAt("-") && !line.isAt("--") && !line.isAt("->");
    }

    private String id(Cursor line) throws Refusal {
        int column = line.column();
        String id = line.id(syntax);
        if (!id.isEmpty() && isDash(line)) {
            int dash = line.column();
            StringBuilder whole = new StringBuilder(id);
            while (isDash(line)) {
                line.take("-");
                whole.append('-').append(line.id(syntax));
            }
            throw new Refusal(
                    dash,
                    "Mermaid allows no '-' in an id; write " + whole.toString().replace('-', '_') + ", and state \""
                            + whole + "\" as " + whole.toString().replace('-', '_') + " once for its name");
        }
        if (line.isAt(".") && syntax == Syntax.PLANTUML) {
            throw new Refusal(
                    line.column(),
                    "PlantUML reads '.' in an id as a state inside '" + id + "'; write an id without it, and state"
                            + " \"NAME\" as ID for the name");
        }
        if (syntax == Syntax.MERMAID && (line.isAt(";") || (!id.isEmpty() && line.isAt("[") && !line.isAt("[H")))) {
            throw new Refusal(
                    line.column(),
                    "'" + line.letter() + "' would be a part of the id in Mermaid; remove it, and write state \"NAME\""
                            + " as ID for another name");
        }
        if (id.isEmpty()) {
            throw new Refusal(
                    column,
                    line.hasMore()
                            ? "an id cannot begin with '" + line.letter() + "'; write letters, digits and _"
                            : "the id of a state is missing; write one");
        }
        return id;
    }

    private Label label(Cursor line) throws Refusal {
        line.hasMore();
        int column = line.column();
        String label = flat(line.rest());
        refuseMarks(label, column);
        behaviors.noteSlash(label, line.line(), column);
        return Label.parse(label, column, syntax);
    }

    /** Refuses what is no part of the text: a link in PlantUML, and the end of a statement in Mermaid. */
    private void refuseMarks(String text, int column) throws Refusal {
        if (syntax == Syntax.PLANTUML && text.contains("[[")) {
            throw new Refusal(column + text.indexOf("[["), "a link hides the text; write the text alone");
        }
        if (syntax == Syntax.PLANTUML || text.indexOf(';') < 0) {
            return;
        }
        int length;
        for (int i = 0; i < text.length(); i += Math.max(1, length)) {
            length = text.charAt(i) == '#' ? Escapes.lengthAt(text, i, syntax) : 0;
            if (text.charAt(i) == ';') {
                throw new Refusal(
                        column + i,
                        "';' ends a statement in Mermaid, and what follows would be states; remove it at the end of a"
                                + " line, write a comma between effects, or #59; for the letter");
            }
        }
    }

    /** The text with marks in place of each line break, so that columns stay the same. */
    static String flat(String text) {
        return text.indexOf('<') < 0 && text.indexOf('\\') < 0
                ? text
                : BREAK.matcher(text)
                        .replaceAll(found ->
                                String.valueOf(Label.BREAK).repeat(found.group().length()));
    }

    /** The text in a state: a behavior in each line, or a description. */
    private void text(TextState state, Cursor line) throws Refusal {
        line.hasMore();
        int column = line.column();
        String text = line.rest();
        refuseMarks(text, column);
        int from = 0;
        Matcher breaks = BREAK.matcher(text);
        while (breaks.find()) {
            behaviors.read(state, text.substring(from, breaks.start()), line.line(), column + from);
            from = breaks.end();
        }
        behaviors.read(state, text.substring(from), line.line(), column + from);
    }
}
