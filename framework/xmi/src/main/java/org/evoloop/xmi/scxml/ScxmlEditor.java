package org.evoloop.xmi.scxml;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.evoloop.statechart.EventKeywords;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.MachineEditor;
import org.evoloop.xmi.scxml.XmlTags.Element;
import org.evoloop.xmi.scxml.XmlTags.Value;

/** Edits an SCXML document where its elements and attributes are, so that all else stays as it is written. */
@SuppressWarnings("ReferenceEquality") // two elements may look alike
public final class ScxmlEditor implements MachineEditor {
    private static final Set<String> STATES = Set.of("state", "parallel", "final");
    private static final List<String> KEYWORDS = List.of(EventKeywords.SPONTANEOUS, EventKeywords.URGENT);
    private static final String INDENT = "  ";

    private final String file;
    private final XmlTags tags;
    /** What replaces parts of the text, by where they begin; each has where the part ends. */
    private final TreeMap<Integer, Change> changes = new TreeMap<>();

    private final String text;

    private final String lineBreak;

    private record Change(int to, String by) {}

    /** @param file for messages */
    public ScxmlEditor(String file, String text) {
        this.file = file;
        this.text = text;
        this.tags = new XmlTags(text);
        this.lineBreak = text.contains("\r\n") ? "\r\n" : "\n";
    }

    @Override
    public boolean isEmpty() {
        return tags.elements().stream().noneMatch(ScxmlEditor::isState);
    }

    @Override
    public String text() {
        StringBuilder edited = new StringBuilder(text);
        changes.descendingMap().forEach((from, change) -> edited.replace(from, change.to(), change.by()));
        return edited.toString();
    }

    private static boolean isState(Element element) {
        return STATES.contains(element.name());
    }

    private Element root() {
        return tags.elements().stream()
                .filter(element -> element.name().equals("scxml"))
                .findFirst()
                .orElseThrow(() -> new ModelException(file + ": has no element scxml"));
    }

    private Element state(String name) {
        return tags.elements().stream()
                .filter(element -> isState(element) && element.value("id").equals(name))
                .findFirst()
                .orElseThrow(() -> new ModelException("there is no state with the id " + name + " in this machine"));
    }

    private Element transition(int line) {
        List<Element> there = tags.elements().stream()
                .filter(element -> element.name().equals("transition")
                        && element.firstLine() <= line
                        && line <= element.lastLine())
                .toList();
        if (there.size() != 1) {
            throw new ModelException("line " + line + " is not that of one transition; edit it in the text");
        }
        return there.get(0);
    }

    @Override
    public int addState(String name, String parent) {
        requireFree(name);
        Element around = parent.isEmpty() ? root() : state(parent);
        String attribute = "<state id=\"" + escaped(name) + "\"/>";
        boolean first = tags.elements().stream().noneMatch(each -> isState(each) && each.parent() == around);
        if (first && !around.attributes().containsKey("initial")) {
            int end = around.tagEnd() - (around.isEmpty() ? 2 : 1);
            change(end, end, " initial=\"" + escaped(name) + "\"");
        }
        return insertInside(around, attribute);
    }

    private void requireFree(String name) {
        if (!name.matches("[\\p{L}_][\\p{L}\\p{N}_.-]*")) {
            throw new ModelException("'" + name + "' is no id in XML; write letters, digits, '_', '.' and '-'");
        }
        if (tags.elements().stream().anyMatch(each -> each.value("id").equals(name))) {
            throw new ModelException("there is a state named " + name + " already; choose another");
        }
    }

    /** Inserts an element as the last one inside of another one. */
    private int insertInside(Element around, String element) {
        String indent = indent(around.from());
        if (around.isEmpty()) {
            int slash = text.lastIndexOf('/', around.tagEnd());
            String name = text.substring(around.from() + 1).split("[\\s/>]", 2)[0];
            String inside = ">" + lineBreak + indent + INDENT + element + lineBreak + indent;
            change(slash, around.tagEnd(), inside + "</" + name + ">");
            return around.lastLine() + 1;
        }
        int at = text.lastIndexOf('\n', around.end().from());
        if (at < around.tagEnd()) {
            throw new ModelException("line " + around.firstLine() + " holds a whole element; edit it in the text");
        }
        int end = text.charAt(at - 1) == '\r' ? at - 1 : at;
        change(end, end, lineBreak + indent + INDENT + element);
        return (int) text.substring(0, at)
                        .chars()
                        .filter(letter -> letter == '\n')
                        .count()
                + 2;
    }

    private String indent(int offset) {
        int begin = text.lastIndexOf('\n', offset - 1) + 1;
        String line = text.substring(begin, offset);
        return line.isBlank() ? line : "";
    }

    private void change(int from, int to, String by) {
        changes.merge(
                from,
                new Change(to, by),
                (one, other) -> new Change(Math.max(one.to(), other.to()), one.by() + other.by()));
    }

    private static String escaped(String value) {
        return value.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
    }

    @Override
    public int addTransition(String source, String target, String event, String guard) {
        state(target);
        Element from = state(source);
        String element = "<transition"
                + (event.isBlank() ? "" : " event=\"" + escaped(words(event)) + "\"")
                + KEYWORDS.stream()
                        .filter(keyword -> isMarked(event, keyword))
                        .map(keyword -> " " + own(keyword) + "=\"true\"")
                        .collect(Collectors.joining())
                + (guard.isBlank() ? "" : " cond=\"" + escaped(guard.strip()) + "\"")
                + " target=\"" + escaped(target) + "\"/>";
        return insertInside(from, element);
    }

    @Override
    public int renameState(String from, String to) {
        Element state = state(from);
        requireFree(to);
        for (Element each : tags.elements()) {
            for (String attribute : List.of("id", "initial", "target")) {
                Value value = each.attributes().get(attribute);
                if (value != null && (!attribute.equals("id") || each == state)) {
                    String renamed = Arrays.stream(value.decoded().split(" ", -1))
                            .map(word -> word.equals(from) ? to : word)
                            .collect(Collectors.joining(" "));
                    if (!renamed.equals(value.decoded())) {
                        change(value.from(), value.to(), escaped(renamed));
                    }
                }
            }
        }
        return state.firstLine();
    }

    private static String device(Element state) {
        return own(state, "device");
    }

    /** The name of an attribute of ours, with its prefix; empty if the element has none. */
    private static String own(Element element, String name) {
        return element.attributes().keySet().stream()
                .filter(attribute -> attribute.endsWith(":" + name))
                .findFirst()
                .orElse("");
    }

    /** The name for a new attribute of ours, whose namespace is declared. */
    private String own(String name) {
        if (!root().attributes().containsKey("xmlns:ev")) {
            set(root(), "xmlns:ev", "urn:evoloop");
        }
        return "ev:" + name;
    }

    @Override
    public void renameDeviceState(String from, String to) {
        for (Element each : tags.elements()) {
            if (isState(each) && each.value(device(each)).equals(from)) {
                set(each, device(each), to);
            }
        }
    }

    @Override
    public int setDeviceState(String name, String device) {
        Element state = state(name);
        String known = device(state);
        return set(state, known.isEmpty() && !device.isEmpty() ? own("device") : known, device);
    }

    /** Sets an attribute, or removes it if the value is empty. */
    private int set(Element element, String attribute, String value) {
        Value old = element.attributes().get(attribute);
        if (old == null && !value.isEmpty()) {
            int end = element.tagEnd() - (element.isEmpty() ? 2 : 1);
            change(end, end, " " + attribute + "=\"" + escaped(value) + "\"");
        } else if (old != null && !value.isEmpty()) {
            change(old.from(), old.to(), escaped(value));
        } else if (old != null) {
            int begin = text.lastIndexOf(attribute, old.from());
            while (Character.isWhitespace(text.charAt(begin - 1))) {
                begin--;
            }
            change(begin, old.to() + 1, "");
        }
        return element.firstLine();
    }

    /** Events are separated by blanks in SCXML, and their keywords are attributes. */
    private static String words(String events) {
        return names(events).stream().map(EventKeywords::unmarked).collect(Collectors.joining(" "));
    }

    private static List<String> names(String events) {
        return List.of(events.strip().split("\\s*,\\s*"));
    }

    private static boolean isMarked(String events, String keyword) {
        int marked = EventKeywords.marked(names(events), keyword).size();
        if (marked > 0 && marked < names(events).size()) {
            throw new ModelException("in SCXML all events of a transition are «" + keyword
                    + "», or none of them; give each kind a transition of its own");
        }
        return marked > 0;
    }

    @Override
    public int setTrigger(int line, String event) {
        Element transition = transition(line);
        for (String keyword : KEYWORDS) {
            String known = own(transition, keyword);
            if (isMarked(event, keyword)) {
                set(transition, known.isEmpty() ? own(keyword) : known, "true");
            } else if (!known.isEmpty()) {
                set(transition, known, "");
            }
        }
        return set(transition, "event", words(event));
    }

    @Override
    public int setGuard(int line, String guard) {
        return set(transition(line), "cond", guard.strip());
    }

    @Override
    public int setInitial(String name) {
        Element parent = state(name).parent();
        if (parent == null
                || tags.elements().stream()
                        .anyMatch(each -> each.name().equals("initial") && each.parent() == parent)) {
            throw new ModelException("the start is an element initial; edit its target in the text");
        }
        return set(parent, "initial", name);
    }

    @Override
    public int retarget(int line, String source, String target) {
        Element transition = transition(line);
        Element parent = transition.parent();
        if (!source.isEmpty() && (parent == null || !parent.value("id").equals(source))) {
            throw new ModelException(
                    "in SCXML a transition is inside its source; delete it, and draw one from " + source);
        }
        if (!target.isEmpty()) {
            state(target);
        }
        return target.isEmpty() ? line : set(transition, "target", target);
    }

    @Override
    public int deleteTransition(int line) {
        Element transition = transition(line);
        remove(transition);
        return Math.max(1, line - 1);
    }

    /** Removes an element with its line, if it is alone there. */
    private void remove(Element element) {
        int from = element.from();
        int begin = text.lastIndexOf('\n', from - 1) + 1;
        int end = text.indexOf('\n', element.to());
        boolean alone = text.substring(begin, from).isBlank()
                && text.substring(element.to(), end < 0 ? text.length() : end).isBlank();
        change(alone ? begin : from, alone && end >= 0 ? end + 1 : element.to(), "");
    }

    @Override
    public int deleteState(String name) {
        Element state = state(name);
        Set<String> gone = new HashSet<>();
        for (Element each : tags.elements()) {
            if (each.from() >= state.from()
                    && each.to() <= state.to()
                    && !each.value("id").isEmpty()) {
                gone.add(each.value("id"));
            }
        }
        Element parent = state.parent();
        if (parent != null && gone.contains(parent.value("initial"))) {
            throw new ModelException(name + " is where it begins; let another state begin, and then delete it");
        }
        remove(state);
        for (Element each : tags.elements()) {
            boolean outside = each.to() <= state.from() || each.from() >= state.to();
            if (outside && each.name().equals("transition") && gone.contains(each.value("target"))) {
                remove(each);
            }
        }
        return Math.max(1, state.firstLine() - 1);
    }
}
