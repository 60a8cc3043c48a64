package org.evoloop.config;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.evoloop.config.Entry.Value;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.CollectionEndEvent;
import org.snakeyaml.engine.v2.events.CollectionStartEvent;
import org.snakeyaml.engine.v2.events.DocumentStartEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.MappingEndEvent;
import org.snakeyaml.engine.v2.events.MappingStartEvent;
import org.snakeyaml.engine.v2.events.NodeEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.events.SequenceEndEvent;
import org.snakeyaml.engine.v2.events.SequenceStartEvent;
import org.snakeyaml.engine.v2.events.StreamEndEvent;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;

/**
 * Reads a file of options: one mapping of names to values, or lists of them. Values are taken literally, so {@code
 * 08:00} and {@code 0755} remain as written.
 *
 * <p>It reads the parser's events: other features of YAML, such as aliases or nesting, are refused at their line and
 * never evaluated.
 */
final class ConfigFile {
    private static final int DEEPEST = 100;
    private static final String HOW = "write each option as NAME: VALUE on a line of its own";

    private final Path file;
    private final Mistakes mistakes;
    private final StreamReader in;
    private final Iterator<Event> events;
    private final List<Entry> entries = new ArrayList<>();

    private ConfigFile(Path file, String text, Mistakes mistakes) {
        this.file = file;
        this.mistakes = mistakes;
        LoadSettings settings = LoadSettings.builder().build();
        this.in = new StreamReader(settings, text);
        this.events = new ParserImpl(settings, in);
    }

    /** The entries of the file; errors in its form go to {@code mistakes}. */
    static List<Entry> read(Path file, Mistakes mistakes) {
        Optional<String> text = FileText.read(file, mistakes);
        if (text.isEmpty()) {
            mistakes.missSomething();
            return List.of();
        }
        ConfigFile reader = new ConfigFile(file, text.get(), mistakes);
        try {
            reader.document();
        } catch (MarkedYamlEngineException malformed) {
            mistakes.missSomething();
            Optional<Mark> place = malformed.getProblemMark().or(malformed::getContextMark);
            reader.mistake(place, Syntax.message(malformed.getProblem()));
        } catch (NumberFormatException cutOff) {
            // The parser expects hexadecimal digits even where the file ends.
            mistakes.missSomething();
            reader.mistake(
                    reader.in.getMark(),
                    "the file ends in the middle of an escape (\\u, \\x); write \\\\ for a backslash");
        } catch (YamlEngineException unreadable) {
            mistakes.missSomething();
            mistakes.at(Origin.COMMAND_LINE, file + ": cannot be read as options: " + unreadable.getMessage());
        }
        return reader.entries;
    }

    private void document() {
        events.next();
        Event first = events.next();
        if (first instanceof StreamEndEvent) {
            mistakes.missSomething();
            mistakes.at(Origin.COMMAND_LINE, file + ": is empty; " + HOW);
            return;
        }
        Event root = events.next();
        if (!(root instanceof MappingStartEvent)) {
            mistakes.missSomething();
            mistake(root.getStartMark(), "this is " + what(root) + ", not a list of options with values; " + HOW);
            return;
        }
        checkNode((NodeEvent) root);
        for (Event key = events.next(); !(key instanceof MappingEndEvent); key = events.next()) {
            option(key);
        }
        events.next();
        Event end = events.next();
        if (end instanceof DocumentStartEvent) {
            mistake(end.getStartMark(), "a second document begins here; keep one, without a line of ---");
        }
    }

    private void option(Event key) {
        boolean plain = key instanceof ScalarEvent && checkNode((NodeEvent) key);
        if (!(key instanceof ScalarEvent)) {
            mistake(key.getStartMark(), "an option's name is expected, not " + what(key) + "; " + HOW);
            skip(key);
        }
        List<Value> values = new ArrayList<>();
        Event value = events.next();
        boolean list = value instanceof SequenceStartEvent;
        boolean good = plain && checkNode((NodeEvent) value);
        if (list) {
            for (Event item = events.next(); !(item instanceof SequenceEndEvent); item = events.next()) {
                boolean supported = checkNode((NodeEvent) item);
                good &= value(item, values) && supported;
            }
        } else {
            good &= value(value, values);
        }
        if (plain) {
            String name = ((ScalarEvent) key).getValue();
            entries.add(new Entry(name, place(key.getStartMark()), list, good, values));
        }
    }

    /** Adds a value; false if it is not one. */
    private boolean value(Event event, List<Value> values) {
        if (event instanceof ScalarEvent scalar) {
            if (scalar.isPlain() && scalar.getValue().matches("|~|null|Null|NULL")) {
                mistake(
                        event.getStartMark(),
                        "there is no value; write one (in quotes if it begins with #), or leave the line out");
                return false;
            }
            values.add(new Value(scalar.getValue(), place(event.getStartMark())));
            return true;
        }
        if (!(event instanceof AliasEvent)) {
            mistake(
                    event.getStartMark(),
                    "a value is expected, not " + what(event) + "; an option takes text, true or "
                            + "false, or a list of texts");
        }
        skip(event);
        return false;
    }

    /** Refuses unsupported features of YAML; false if it did. */
    private boolean checkNode(NodeEvent node) {
        if (node instanceof AliasEvent || node.getAnchor().isPresent()) {
            mistake(
                    node.getStartMark(),
                    "anchors (&) and aliases (*) are not supported; write the value where it belongs, "
                            + "in quotes if it begins with & or *");
            return false;
        }
        Optional<String> tag = node instanceof ScalarEvent scalar
                ? scalar.getTag()
                : node instanceof CollectionStartEvent collection ? collection.getTag() : Optional.empty();
        if (tag.isPresent()) {
            mistake(
                    node.getStartMark(),
                    "tags (!) are not supported; leave it out, or quote a value that begins with !");
            return false;
        }
        return true;
    }

    private void skip(Event begun) {
        int depth = begun instanceof CollectionStartEvent ? 1 : 0;
        while (depth > 0) {
            Event next = events.next();
            depth += next instanceof CollectionStartEvent ? 1 : next instanceof CollectionEndEvent ? -1 : 0;
            if (depth > DEEPEST) {
                // The parser's time is quadratic in the depth.
                throw new YamlEngineException("it is nested more than " + DEEPEST + " levels deep");
            }
        }
    }

    private static String what(Event event) {
        return event instanceof MappingStartEvent
                ? "a mapping"
                : event instanceof SequenceStartEvent ? "a list" : "a text";
    }

    private void mistake(Optional<Mark> place, String mistake) {
        mistakes.at(place(place), mistake);
    }

    private Origin place(Optional<Mark> mark) {
        return Origin.in(file, mark.map(Mark::getLine).orElse(0) + 1);
    }
}
