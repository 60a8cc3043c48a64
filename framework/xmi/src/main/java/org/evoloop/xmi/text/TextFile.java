package org.evoloop.xmi.text;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.Problems;

/** Splits a text into its state diagrams. */
final class TextFile {
    /** The first word of Mermaid's diagrams. */
    static final String DIAGRAM = "(stateDiagram(?:-v2)?|flowchart(?:-elk)?|graph|sequenceDiagram|classDiagram(?:-v2)?"
            + "|erDiagram|gantt|pie|journey|gitGraph|mindmap|timeline|quadrantChart|requirementDiagram|C4\\w+"
            + "|sankey(?:-beta)?|xychart(?:-beta)?|block(?:-beta)?|packet(?:-beta)?|kanban|architecture(?:-beta)?"
            + "|radar(?:-beta)?|zenuml|info)(?=[\\s;:]|$)";

    private static final Pattern MERMAID_HEAD = Pattern.compile("\\s*" + DIAGRAM + "\\s*(.*)");
    private static final Map<String, String> KINDS = Map.ofEntries(
            Map.entry("flowchart", "a flowchart"),
            Map.entry("graph", "a flowchart"),
            Map.entry("sequencediagram", "a sequence diagram"),
            Map.entry("classdiagram", "a class diagram"),
            Map.entry("erdiagram", "an entity relationship diagram"),
            Map.entry("gantt", "a Gantt chart"),
            Map.entry("pie", "a pie chart"),
            Map.entry("journey", "a user journey"),
            Map.entry("gitgraph", "a Git graph"),
            Map.entry("mindmap", "a mind map"),
            Map.entry("timeline", "a timeline"));
    private static final Pattern TITLE = Pattern.compile("\\s*title\\s*:\\s*(.+?)\\s*");
    private static final Pattern PLANTUML_TITLE = Pattern.compile("(?i)\\s*title\\s+(\\S.*?)\\s*");
    private static final Pattern START = Pattern.compile("(?i)\\s*@start(\\w+)(?:\\s*\\([^)]*\\))?\\s*(.*?)\\s*");
    private static final Pattern END = Pattern.compile("(?i)\\s*@end\\w+.*");
    private static final Pattern FENCE = Pattern.compile("\\s*(```+|~~~+)\\s*\\{?\\.?(\\w*)(.*)");
    private static final Pattern HEADING = Pattern.compile("\\s{0,3}#{1,6}\\s+(.*?)\\s*#*\\s*");
    /** Makes the line above it a heading. */
    private static final Pattern UNDERLINE = Pattern.compile("\\s{0,3}(=+|-{2,})\\s*");

    private static final Pattern PLANTUML_STATE = Pattern.compile("(?i)\\s*state\\s.*|.*\\[\\*\\].*|.*\\[H\\*?\\].*");
    private static final List<Map.Entry<Pattern, String>> PLANTUML_KINDS = List.of(
            Map.entry(
                    Pattern.compile("\\s*(participant|actor|activate|alt|loop|autonumber)\\b.*"), "a sequence diagram"),
            Map.entry(Pattern.compile("\\s*(abstract\\s+)?(class|interface|enum)\\s.*"), "a class diagram"),
            Map.entry(Pattern.compile("\\s*(start|stop|:.*;|if\\s*\\(.*)\\s*"), "an activity diagram"),
            Map.entry(Pattern.compile("\\s*(usecase\\b.*|\\(.*\\).*)"), "a use case diagram"),
            Map.entry(Pattern.compile("\\s*(component\\b.*|\\[.*\\].*)"), "a component diagram"),
            Map.entry(Pattern.compile("\\s*\\w+\\s*-+>+\\s*\\w+.*"), "a sequence diagram"));

    private static final String BEGIN_MERMAID = "begin a state diagram with stateDiagram-v2";
    private static final String BEGIN_PLANTUML = "a state diagram has states, as in [*] --> Off";

    private final String file;
    private final List<String> lines;
    private final Kind kind;
    private final List<TextBlock> blocks = new ArrayList<>();
    /** Diagrams of other kinds, which a Markdown file may hold beside those of states. */
    private final List<String> others = new ArrayList<>();

    /** What a text is written in. */
    enum Kind {
        MERMAID,
        PLANTUML,
        MARKDOWN;

        static Kind of(String text) {
            if (Pattern.compile("(?m)^[ \\t]*+(?:```+|~~~+)[ \\t]*+\\w")
                    .matcher(text)
                    .find()) {
                return MARKDOWN;
            }
            return Pattern.compile("(?mi)^[ \\t]*+@start\\w").matcher(text).find() ? PLANTUML : MERMAID;
        }
    }

    TextFile(String file, String text, Kind kind) {
        this.file = file;
        this.lines = text.lines().toList();
        this.kind = kind;
    }

    /**
     * The state diagrams, in order.
     *
     * @throws ModelException if there is none, or a block is not closed
     */
    List<TextBlock> blocks() {
        if (lines.stream().allMatch(String::isBlank)) {
            throw new ModelException(file + ": is empty: write a state diagram");
        }
        switch (kind) {
            case MERMAID -> mermaid(0, lines.size(), fileName());
            case PLANTUML -> plantUml(0, lines.size(), fileName());
            case MARKDOWN -> markdown();
        }
        if (blocks.isEmpty() && kind == Kind.MARKDOWN) {
            throw new ModelException(file + ": holds no state diagram"
                    + (others.isEmpty()
                            ? ""
                            : ", but " + String.join(", ", others.subList(0, Math.min(5, others.size()))))
                    + ": write one in a block ```mermaid that begins with stateDiagram-v2");
        }
        if (blocks.isEmpty()) {
            throw new ModelException(file + ": "
                    + (others.isEmpty() ? "holds no diagram" : "is " + others.get(0) + ", not a state diagram") + ": "
                    + (kind == Kind.PLANTUML ? BEGIN_PLANTUML : BEGIN_MERMAID));
        }
        return blocks;
    }

    private String fileName() {
        String name = String.valueOf(Path.of(file).getFileName());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    private void markdown() {
        String heading = "";
        int begin = lines.get(0).strip().equals("---") ? Math.max(0, closing(0, "---")) : 0;
        for (int i = begin; i < lines.size(); i++) {
            Matcher fence = FENCE.matcher(lines.get(i));
            Matcher title = HEADING.matcher(lines.get(i));
            if (title.matches()) {
                heading = plain(title.group(1));
            } else if (i > begin && UNDERLINE.matcher(lines.get(i)).matches() && isProse(lines.get(i - 1))) {
                heading = plain(lines.get(i - 1));
            }
            if (!fence.matches()) {
                continue;
            }
            int end = closing(i, fence.group(1));
            switch (fence.group(2).toLowerCase(Locale.ROOT)) {
                case "mermaid" -> {
                    requireClosed(i, end, fence.group(1));
                    mermaid(i + 1, end, heading);
                }
                case "plantuml", "puml", "uml" -> {
                    requireClosed(i, end, fence.group(1));
                    plantUml(i + 1, end, heading);
                }
                case "" -> noLanguage(i, end);
                default -> {}
            }
            i = end < 0 ? lines.size() : end;
        }
    }

    /** A diagram in a block that says no language is not drawn by anybody, so it may be a mistake. */
    private void noLanguage(int begin, int end) {
        if (begin + 1 < (end < 0 ? lines.size() : end)) {
            String first = lines.get(begin + 1);
            boolean mermaid = first.strip().startsWith("stateDiagram");
            if (mermaid || START.matcher(first).matches()) {
                others.add("a diagram in a block without a language" + line(begin) + "; write "
                        + lines.get(begin).strip() + (mermaid ? "mermaid" : "plantuml"));
            }
        }
    }

    private static String plain(String heading) {
        return heading.replaceAll("[`*]", "").strip();
    }

    private static boolean isProse(String line) {
        return !line.isBlank()
                && !FENCE.matcher(line).matches()
                && !HEADING.matcher(line).matches();
    }

    /** The index of the line that closes the block; negative if none does. */
    private int closing(int begin, String fence) {
        for (int i = begin + 1; i < lines.size(); i++) {
            String line = lines.get(i).strip();
            if (line.startsWith(fence) && line.chars().allMatch(letter -> letter == fence.charAt(0))) {
                return i;
            }
        }
        return -1;
    }

    private void requireClosed(int begin, int end, String fence) {
        if (end < 0) {
            throw new ModelException(file + ": its block is not closed (line " + (begin + 1) + "): write " + fence
                    + " behind the diagram");
        }
    }

    /** Reads a diagram of Mermaid in these lines. */
    private void mermaid(int from, int to, String name) {
        String title = name;
        int at = from;
        while (at < to && lines.get(at).isBlank()) {
            at++;
        }
        if (at < to && lines.get(at).strip().equals("---")) {
            int begin = at++;
            while (at < to && !lines.get(at).strip().equals("---")) {
                Matcher given = TITLE.matcher(lines.get(at++));
                title = given.matches() ? yaml(given.group(1)) : title;
            }
            if (at++ >= to) {
                throw new ModelException(
                        file + ": its title is not closed (line " + (begin + 1) + "): write --- behind it");
            }
        }
        boolean directive = false;
        while (at < to
                && (directive
                        || lines.get(at).isBlank()
                        || lines.get(at).strip().startsWith("%%"))) {
            String line = lines.get(at++);
            directive = (directive || line.strip().startsWith("%%{")) && !line.contains("}%%");
        }
        if (at >= to) {
            return;
        }
        Matcher head = MERMAID_HEAD.matcher(lines.get(at));
        if (!head.matches()) {
            others.add("no Mermaid diagram that is known" + line(at));
        } else if (!head.group(1).startsWith("stateDiagram")) {
            String word = head.group(1).replaceFirst("-.*", "").toLowerCase(Locale.ROOT);
            others.add(KINDS.getOrDefault(word, "a Mermaid diagram of kind " + head.group(1)) + line(at));
        } else if (!head.group(2).matches("(%%.*)?")) {
            throw new ModelException(file + ": " + Problems.quote(head.group(2).strip()) + " is behind " + head.group(1)
                    + line(at) + ": write it in the next line");
        } else {
            add(Syntax.MERMAID, title, at, to);
        }
    }

    /** The text of a YAML scalar, without its quotation marks. */
    private static String yaml(String scalar) {
        boolean quoted = scalar.matches("\".*\"|'.*'");
        if (!quoted) {
            return scalar;
        }
        String inside = scalar.substring(1, scalar.length() - 1);
        return scalar.startsWith("'") ? inside.replace("''", "'") : inside.replaceAll("\\\\([\"\\\\])", "$1");
    }

    /** Reads the diagrams of PlantUML in these lines. In Markdown they need not be between @startuml and @enduml. */
    private void plantUml(int from, int to, String name) {
        boolean found = false;
        for (int i = from; i < to; i++) {
            Matcher start = START.matcher(lines.get(i));
            if (start.matches()) {
                found = true;
                int end = i + 1;
                while (end < to && !END.matcher(lines.get(end)).matches()) {
                    end++;
                }
                if (end >= to) {
                    throw new ModelException(file + ": its diagram is not closed (line " + (i + 1) + "): write @end"
                            + start.group(1) + " behind it");
                }
                String given = start.group(2).replace("\"", "");
                if (start.group(1).equalsIgnoreCase("uml")) {
                    plantUmlDiagram(i, end, given.isEmpty() ? name : given);
                } else {
                    others.add("a PlantUML diagram of kind " + start.group(1) + line(i));
                }
                i = end;
            }
        }
        if (!found && from < to) {
            plantUmlDiagram(from - 1, to, name);
        }
    }

    /** @param head the index of the line before the diagram */
    private void plantUmlDiagram(int head, int to, String name) {
        List<String> inside = lines.subList(head + 1, to);
        if (inside.stream().anyMatch(line -> PLANTUML_STATE.matcher(line).matches())) {
            Optional<String> title = inside.stream()
                    .map(PLANTUML_TITLE::matcher)
                    .filter(Matcher::matches)
                    .map(found -> found.group(1))
                    .filter(text -> !text.startsWith("-"))
                    .findFirst();
            add(Syntax.PLANTUML, title.orElse(name), head, to);
            return;
        }
        others.add(PLANTUML_KINDS.stream()
                        .filter(other -> inside.stream()
                                .anyMatch(line -> other.getKey().matcher(line).matches()))
                        .map(Map.Entry::getValue)
                        .findFirst()
                        .orElse("a PlantUML diagram without states")
                + line(Math.max(0, head)));
    }

    private void add(Syntax syntax, String title, int head, int to) {
        blocks.add(new TextBlock(file, syntax, title, head + 1, lines.subList(head + 1, to)));
    }

    private static String line(int index) {
        return " (line " + (index + 1) + ")";
    }
}
