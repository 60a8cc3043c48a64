package org.evoloop.device.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.CollectionStartEvent;
import org.snakeyaml.engine.v2.events.DocumentStartEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.MappingEndEvent;
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
 * Reads YAML as a tree of texts, lists and mappings. Values are taken literally; anchors, aliases, tags and a second
 * document are refused at their line, and never evaluated.
 */
final class Yaml {
    private static final int LARGEST = 1 << 18;
    /** A file of devices needs fewer than ten; the parser's time is quadratic in the depth. */
    private static final int DEEPEST = 50;

    private final Problems problems;
    private final Iterator<Event> events;
    private int depth;

    private Yaml(String text, Problems problems) {
        LoadSettings settings = LoadSettings.builder().build();
        this.problems = problems;
        this.events = new ParserImpl(settings, new StreamReader(settings, text));
    }

    /**
     * The mapping that a file is.
     *
     * @throws DeviceFileException if it is none, or cannot be read
     */
    static Node.Entries read(Path file, Problems problems) {
        return parse(text(file), problems);
    }

    /** As {@link #read}, of this text. */
    static Node.Entries parse(String text, Problems problems) {
        try {
            Node root = new Yaml(text, problems).document();
            if (root instanceof Node.Entries entries) {
                problems.throwIfAny();
                return entries;
            }
            problems.at(
                    root, "this is " + root.kind() + "; a device file has sections, such as connections: and device:");
        } catch (MarkedYamlEngineException malformed) {
            Malformed place = Malformed.of(malformed, text);
            problems.at(place.line(), place.mistake());
        } catch (NumberFormatException cutOff) {
            // The parser expects hexadecimal digits even where the file ends.
            problems.at(lines(text), "the file ends in the middle of an escape (\\u, \\x); write \\\\ for a backslash");
        } catch (YamlEngineException unreadable) {
            problems.at(1, "this cannot be read: " + unreadable.getMessage());
        }
        problems.throwIfAny();
        throw new IllegalStateException("a problem is missing");
    }

    private static String text(Path file) {
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes(LARGEST + 1);
            if (bytes.length > LARGEST) {
                throw new DeviceFileException(
                        file + ": is larger than 256 kB, which no device file is; correct the path");
            }
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(java.nio.ByteBuffer.wrap(bytes))
                    .toString();
        } catch (CharacterCodingException otherEncoding) {
            throw new DeviceFileException(file + ": is not text in UTF-8; save it in this encoding");
        } catch (NoSuchFileException missing) {
            throw new DeviceFileException(file + ": does not exist; correct the path");
        } catch (AccessDeniedException denied) {
            throw new DeviceFileException(file + ": permission denied; let this program's user read it");
        } catch (IOException failure) {
            throw new DeviceFileException(file
                    + (Files.isDirectory(file)
                            ? ": is a directory; name a file in it"
                            : ": cannot be read: " + failure.getMessage()));
        }
    }

    private Node document() {
        events.next();
        if (events.next() instanceof StreamEndEvent) {
            return new Node.Text(1, "", true);
        }
        Node root = node(events.next());
        events.next();
        Event end = events.next();
        if (end instanceof DocumentStartEvent) {
            problems.at(line(end.getStartMark()), "a second document begins here; keep one, without a line of ---");
        }
        return root;
    }

    private Node node(Event begun) {
        int line = line(begun.getStartMark());
        requirePlain((NodeEvent) begun, line);
        if (begun instanceof ScalarEvent scalar) {
            return new Node.Text(line, scalar.getValue(), scalar.isPlain());
        }
        if (begun instanceof AliasEvent) {
            return new Node.Text(line, "", false);
        }
        if (++depth > DEEPEST) {
            throw new YamlEngineException("it is nested more than " + DEEPEST + " levels deep");
        }
        Node node = begun instanceof SequenceStartEvent ? items(line) : entries(line);
        depth--;
        return node;
    }

    private Node items(int line) {
        List<Node> items = new ArrayList<>();
        for (Event next = events.next(); !(next instanceof SequenceEndEvent); next = events.next()) {
            items.add(node(next));
        }
        return new Node.Items(line, items);
    }

    private Node entries(int line) {
        Map<Node.Text, Node> entries = new LinkedHashMap<>();
        Map<String, Integer> lines = new LinkedHashMap<>();
        for (Event next = events.next(); !(next instanceof MappingEndEvent); next = events.next()) {
            Node key = node(next);
            Node value = node(events.next());
            if (!(key instanceof Node.Text text)) {
                problems.at(key, "a name is expected before the colon, not " + key.kind());
                continue;
            }
            Integer before = lines.putIfAbsent(text.value(), text.line());
            if (before != null) {
                problems.at(key, "'" + text + "' is given twice, first in line " + before + "; keep one");
            } else {
                entries.put(text, value);
            }
        }
        return new Node.Entries(line, entries);
    }

    private void requirePlain(NodeEvent node, int line) {
        if (node instanceof AliasEvent || node.getAnchor().isPresent()) {
            problems.at(
                    line,
                    "anchors (&) and aliases (*) are not supported; write the value where it belongs, in quotes if it"
                            + " begins with & or *");
        }
        Optional<String> tag = node instanceof ScalarEvent scalar
                ? scalar.getTag()
                : node instanceof CollectionStartEvent collection ? collection.getTag() : Optional.empty();
        if (tag.isPresent()) {
            problems.at(line, "tags (!) are not supported; leave it out, or quote a value that begins with !");
        }
    }

    private static int line(Optional<Mark> mark) {
        return mark.map(Mark::getLine).orElse(0) + 1;
    }

    private static int lines(String text) {
        return 1 + (int) text.chars().filter(each -> each == '\n').count();
    }
}
