package org.evoloop.xmi.text;

import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.MachineEditor;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.text.Statement.Kind;
import org.evoloop.xmi.text.Statement.Mark;

/**
 * Edits a state diagram of Mermaid or PlantUML by the places of the statements that the reader has found.
 *
 * <p>A line in a state's contents belongs to it, and in Mermaid so do the states that the line names. So a transition is
 * written in the region of both its ends, or else outside of all states, where it moves nothing.
 */
@SuppressWarnings("ReferenceEquality") // two regions may look alike
public final class TextEditor implements MachineEditor {
    private static final String INDENT = TextPlaces.INDENT;
    private static final Pattern ID = Pattern.compile("\\p{L}[\\p{L}\\p{N}_]*");

    private final Lines lines;
    private final Syntax syntax;
    private final TextBlock block;
    private final Statements reader;
    private final TextPlaces places;
    private final List<Statement> statements;
    private final Map<String, ChartState> index = new LinkedHashMap<>();

    private TextEditor(String text, TextBlock block) {
        this.lines = new Lines(text);
        this.syntax = block.syntax();
        this.block = block;
        this.reader = new Statements(block, new Problems());
        index(reader.chart(block.title()).regions());
        this.statements = reader.read();
        this.places = new TextPlaces(block, lines, statements);
    }

    /**
     * An editor of one machine of a text.
     *
     * @param line the machine's first line
     */
    public static TextEditor of(String file, String text, int line) {
        TextBlock block = TextDialect.blocks(file, text).stream()
                .filter(each -> each.line() == line)
                .findFirst()
                .orElseThrow(() -> new ModelException(file + ": no diagram begins in line " + line));
        return new TextEditor(text, block);
    }

    private void index(List<Region> regions) {
        for (Region region : regions) {
            for (Vertex vertex : region.vertices()) {
                if (vertex instanceof ChartState state) {
                    index.put(state.key(), state);
                    index(state.regions());
                }
            }
        }
    }

    @Override
    public boolean isEmpty() {
        return reader.tree().states().isEmpty();
    }

    @Override
    public String text() {
        return lines.toString();
    }

    @Override
    public int addState(String name, String parent) {
        String id = freeId(name);
        Scope scope = reader.tree().top();
        if (!parent.isEmpty()) {
            TextState around = state(parent);
            if (around.regions.isEmpty()) {
                return open(around, id, name);
            }
            scope = around.regions.get(0);
        }
        Scope home = scope;
        boolean starts = statements.stream().noneMatch(each -> isStart(each, home));
        int last = places.lastIn(home);
        if (!id.equals(name)) {
            last = places.insert(last, home, "state \"" + shown(name) + "\" as " + id);
        }
        return id.equals(name) || starts ? places.insert(last, home, starts ? "[*] --> " + id : declaration(id)) : last;
    }

    /** Gives a state its first contents. */
    private int open(TextState around, String id, String name) {
        Statement declared = statements.stream()
                .filter(each -> each.kind() == Kind.DECLARATION && each.names(around.id()))
                .findFirst()
                .orElse(null);
        boolean isWhole = declared != null && lines.get(declared.line()).strip().startsWith("state ");
        Scope home = home(around);
        int at;
        if (declared != null && isWhole) {
            at = declared.line();
            lines.set(at, lines.get(at).stripTrailing() + " {");
        } else if (declared != null) {
            at = declared.line();
            lines.set(at, lines.indent(at) + "state " + around.id() + " {");
        } else {
            at = places.insert(places.lastIn(home), home, "state " + around.id() + " {");
        }
        String indent = lines.indent(at);
        lines.insert(at + 1, indent + INDENT + "[*] --> " + id);
        int added = at + 1;
        if (!id.equals(name)) {
            lines.insert(++added, indent + INDENT + "state \"" + shown(name) + "\" as " + id);
        }
        lines.insert(added + 1, indent + "}");
        return added;
    }

    private String declaration(String id) {
        return syntax == Syntax.PLANTUML ? "state " + id : id;
    }

    private String freeId(String name) {
        requireFree(name, "");
        if (isId(name)) {
            return name;
        }
        int number = 1;
        while (reader.tree().known("s" + number) != null) {
            number++;
        }
        return "s" + number;
    }

    private void requireFree(String name, String except) {
        boolean known = index.values().stream()
                .anyMatch(state -> !state.key().equals(except) && state.name().equals(name));
        if (name.isBlank() || known || (!name.equals(except) && reader.tree().known(name) != null)) {
            throw new ModelException(
                    name.isBlank()
                            ? "a name is missing"
                            : "there is a state named " + name + " already; choose another");
        }
    }

    private boolean isId(String name) {
        return Words.isId(name) && ID.matcher(name).matches();
    }

    private String shown(String name) {
        return syntax == Syntax.MERMAID ? Words.name(name) : name.replace('"', '\'');
    }

    @Override
    public int addTransition(String source, String target, String event, String guard) {
        TextState from = state(source);
        TextState to = state(target);
        String label =
                TextLabel.of("", syntax).withTrigger(event).withGuard(guard).text();
        String arrow = from.id() + " --> " + to.id() + (label.isEmpty() ? "" : " : " + label);
        return insertArrow(from, to, arrow);
    }

    /** Where a transition is written. */
    private Scope scopeOf(TextState from, TextState to) {
        return home(from) == home(to) ? home(from) : reader.tree().top();
    }

    /** Inserts the line behind the last transition of its source, or else behind all others of its region. */
    private int insertArrow(TextState from, TextState to, String arrow) {
        Scope scope = scopeOf(from, to);
        int behind = statements.stream()
                .filter(each -> each.scope() == scope && each.kind() == Kind.ARROW)
                .filter(each -> Objects.requireNonNull(each.first()).id().equals(from.id()))
                .mapToInt(Statement::line)
                .max()
                .orElseGet(() -> places.lastIn(scope));
        return places.insert(behind, scope, arrow);
    }

    @Override
    public int renameState(String from, String to) {
        TextState state = state(from);
        requireFree(to, state.id());
        Statement shown = statements.stream()
                .filter(each -> each.shown() != null && each.names(state.id()))
                .findFirst()
                .orElse(null);
        if (shown != null) {
            Mark name = Objects.requireNonNull(shown.shown());
            int keywords = name.id().lastIndexOf('»') + 1;
            String kept = name.id().substring(0, keywords) + (keywords > 0 ? " " : "");
            lines.replace(shown.line(), name.from(), name.to(), kept + shown(to));
            return shown.line();
        }
        return isId(to) ? renameId(state.id(), to) : nameBeside(state, to);
    }

    private int renameId(String from, String to) {
        Set<Integer> named = new HashSet<>();
        // From the last to the first, so that places in the same line stay true.
        statements.stream()
                .flatMap(each -> Stream.of(each.first(), each.second())
                        .filter(mark -> mark != null && mark.id().equals(from))
                        .map(mark -> new Place(each.line(), Objects.requireNonNull(mark))))
                .sorted(Comparator.comparingInt((Place place) -> place.mark().from())
                        .reversed())
                .forEach(place -> {
                    lines.replace(
                            place.line(), place.mark().from(), place.mark().to(), to);
                    named.add(place.line());
                });
        for (int line : places.ignored()) {
            lines.set(line, lines.get(line).replaceAll(beside(from), to));
        }
        return named.stream().min(Comparator.naturalOrder()).orElse(block.line());
    }

    private record Place(int line, Mark mark) {}

    /** Matches an id that a note or a style names, but not in the text of a note. */
    private static String beside(String id) {
        return "(?<![\\p{L}\\p{N}_:])" + Pattern.quote(id) + "(?![\\p{L}\\p{N}_])(?<!:.{0,200})";
    }

    /** Gives a state a name that cannot be its id. */
    private int nameBeside(TextState state, String name) {
        Statement opening = statements.stream()
                .filter(each -> each.kind() == Kind.OPENING && each.names(state.id()))
                .findFirst()
                .orElse(null);
        String shown = "\"" + shown(name) + "\" as ";
        if (opening != null) {
            Mark id = Objects.requireNonNull(opening.first());
            lines.replace(opening.line(), id.from(), id.from(), shown);
            return opening.line();
        }
        Scope home = home(state);
        int before = statements.stream()
                .filter(each -> each.scope() == home && each.names(state.id()))
                .mapToInt(Statement::line)
                .min()
                .orElse(places.lastIn(home) + 1);
        return places.insert(before - 1, home, "state " + shown + state.id());
    }

    @Override
    public void renameDeviceState(String from, String to) {
        for (ChartState state : index.values()) {
            if (state.use().device().equals(from)) {
                changeKeyword(state, to);
            }
        }
    }

    @Override
    public int setDeviceState(String name, String device) {
        TextState state = state(name);
        ChartState drawn = index.get(state.id());
        if (drawn != null && !drawn.use().device().isEmpty()) {
            return changeKeyword(drawn, device);
        }
        if (device.isEmpty()) {
            return state.place().line();
        }
        Scope home = home(state);
        Comparator<Statement> byLine = Comparator.comparingInt(Statement::line);
        Supplier<Stream<Statement>> naming =
                () -> statements.stream().filter(each -> each.scope() == home && each.names(state.id()));
        int behind = naming.get()
                .filter(each -> each.kind() != Kind.ARROW)
                .max(byLine)
                .map(places::end)
                .or(() -> naming.get().min(byLine).map(Statement::line))
                .orElseGet(() -> places.lastIn(home));
        return places.insert(behind, home, state.id() + " : «device " + device + "»");
    }

    /** Replaces the device state in the keyword of a state, or removes the keyword. */
    private int changeKeyword(ChartState state, String device) {
        Pattern keyword = Pattern.compile(
                "(?:«|<<)\\s*device\\s+(" + Pattern.quote(state.use().device()) + ")\\s*(?:»|>>) ?");
        for (Statement each : statements) {
            Matcher found = keyword.matcher(lines.get(each.line()));
            if (each.names(state.key()) && found.find()) {
                int line = each.line();
                String without = found.replaceFirst("");
                if (!device.isEmpty()) {
                    lines.replace(line, found.start(1), found.end(1), device);
                } else if (without.strip().equals(state.key() + " :")) {
                    lines.remove(line);
                } else {
                    lines.set(line, without);
                }
                return line;
            }
        }
        throw new ModelException("the keyword of " + state.name() + " stands among others; edit it in the text");
    }

    @Override
    public int setTrigger(int line, String event) {
        return relabel(line, label -> label.withTrigger(event));
    }

    @Override
    public int setGuard(int line, String guard) {
        return relabel(line, label -> label.withGuard(guard));
    }

    private int relabel(int line, UnaryOperator<TextLabel> change) {
        Statement statement = places.only(line, each -> each.kind() == Kind.ARROW || each.kind() == Kind.DESCRIPTION);
        String content = lines.get(line);
        int from = statement.text();
        String behind = from < 0 ? "" : content.substring(from);
        String before = from < 0 ? content.stripTrailing() + " : " : content.substring(0, from);
        int blank = behind.length() - behind.stripLeading().length();
        String label =
                change.apply(TextLabel.of(behind.substring(blank), syntax)).text();
        boolean isBare = label.isEmpty() && statement.kind() == Kind.ARROW;
        lines.set(
                line,
                isBare
                        ? before.stripTrailing().replaceFirst("\\s*:$", "")
                        : before + behind.substring(0, blank) + label);
        return line;
    }

    @Override
    public int setInitial(String name) {
        TextState state = state(name);
        Scope home = home(state);
        Statement start = statements.stream()
                .filter(each -> isStart(each, home))
                .findFirst()
                .orElse(null);
        if (start == null) {
            return places.insert(home.place().line(), home, "[*] --> " + state.id());
        }
        Mark target = Objects.requireNonNull(start.second());
        lines.replace(start.line(), target.from(), target.to(), state.id());
        declareIfLost(Set.of(start), start.line(), state.id());
        return start.line();
    }

    private static boolean isStart(Statement statement, Scope scope) {
        Mark first = statement.first();
        return statement.kind() == Kind.ARROW
                && statement.scope() == scope
                && first != null
                && first.id().isEmpty();
    }

    @Override
    public int retarget(int line, String source, String target) {
        Statement arrow = places.only(line, each -> each.kind() == Kind.ARROW);
        Mark first = Objects.requireNonNull(arrow.first());
        Mark second = Objects.requireNonNull(arrow.second());
        String from = source.isEmpty() ? first.id() : state(source).id();
        String to = target.isEmpty() ? second.id() : state(target).id();
        if (first.from() < second.from()) {
            lines.replace(line, second.from(), second.to(), end(to));
            lines.replace(line, first.from(), first.to(), end(from));
        } else {
            lines.replace(line, first.from(), first.to(), end(from));
            lines.replace(line, second.from(), second.to(), end(to));
        }
        TextState begin = reader.tree().known(from);
        TextState end = reader.tree().known(to);
        Scope here = arrow.scope();
        if (begin == null || end == null || here.owner() == null || (home(begin) == here && home(end) == here)) {
            declareIfLost(Set.of(arrow), line, from, to);
            return line;
        }
        // Its new place is found by the lines as they were read.
        int at = insertArrow(begin, end, lines.get(line).strip());
        int old = at <= line ? line + 1 : line;
        lines.remove(old);
        int lost = declareIfLost(
                Set.of(arrow),
                old - 1,
                Stream.of(from, to)
                        .filter(id -> isHome(scopeOf(begin, end), id))
                        .toArray(String[]::new));
        return at <= line ? at : at - 1 + lost;
    }

    private static String end(String id) {
        return id.isEmpty() ? "[*]" : id;
    }

    @Override
    public int deleteTransition(int line) {
        Statement arrow = places.only(line, each -> each.kind() == Kind.ARROW || each.kind() == Kind.DESCRIPTION);
        lines.remove(line);
        declareIfLost(Set.of(arrow), line - 1);
        return Math.max(block.line(), line - 1);
    }

    /** Declares the states that nothing but {@code gone} names in their region, except those that are named {@code still}; how many. */
    private int declareIfLost(Set<Statement> gone, int behind, String... still) {
        Set<String> lost = new LinkedHashSet<>();
        for (Statement each : gone) {
            Stream.of(each.first(), each.second())
                    .filter(mark -> mark != null && !mark.id().isEmpty())
                    .forEach(mark -> lost.add(Objects.requireNonNull(mark).id()));
        }
        List.of(still).forEach(lost::remove);
        statements.stream()
                .filter(each -> !gone.contains(each))
                .forEach(each -> lost.removeIf(id -> each.names(id) && isHome(each.scope(), id)));
        for (String id : lost) {
            TextState state = reader.tree().known(id);
            if (state != null && state.kind() == null) {
                places.insert(behind, home(state), declaration(id));
            }
        }
        return lost.size();
    }

    @Override
    public int deleteState(String name) {
        TextState state = state(name);
        Set<String> inside = new HashSet<>(Set.of(state.id()));
        reader.tree().states().values().forEach(each -> {
            Scope home = home(each);
            if (state.regions.stream().anyMatch(region -> region.encloses(home))) {
                inside.add(each.id());
            }
        });
        Set<Statement> gone = new LinkedHashSet<>();
        Set<Integer> numbers = new TreeSet<>(Comparator.reverseOrder());
        for (Statement each : statements) {
            if (inside.stream().anyMatch(each::names)) {
                gone.add(each);
                for (int line = each.line(); line <= places.end(each); line++) {
                    numbers.add(line);
                }
            }
        }
        statements.stream().filter(each -> numbers.contains(each.line())).forEach(gone::add);
        places.ignored().stream()
                .filter(line -> inside.stream()
                        .anyMatch(id -> lines.get(line).matches("\\s*(?:note|style|click)\\s.*" + beside(id) + ".*")))
                .forEach(line -> numbers.addAll(places.ignored(line)));
        numbers.forEach(lines::remove);
        int first = gone.stream().mapToInt(Statement::line).min().orElse(block.line() + 1);
        declareIfLost(gone, Math.max(block.line(), first - 1), inside.toArray(String[]::new));
        return Math.max(block.line(), first - 1);
    }

    private TextState state(String name) {
        List<String> found = index.values().stream()
                .filter(each -> each.name().equals(name))
                .map(ChartState::key)
                .toList();
        TextState known = reader.tree().known(found.size() == 1 ? found.get(0) : name);
        if (known == null) {
            throw new ModelException("there is no state named " + name + " in this machine");
        }
        return known;
    }

    private boolean isHome(Scope scope, String id) {
        TextState state = reader.tree().known(id);
        return state == null || home(state) == scope;
    }

    private Scope home(TextState state) {
        Scope home = state.home();
        return home == null ? reader.tree().top() : home;
    }
}
