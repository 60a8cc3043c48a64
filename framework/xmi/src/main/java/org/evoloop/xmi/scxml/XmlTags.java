package org.evoloop.xmi.scxml;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Where the elements of a well-formed document are in its text. */
final class XmlTags {
    private static final Pattern TAG = Pattern.compile(
            "<!--.*?-->|<!\\[CDATA\\[.*?]]>|<\\?.*?\\?>|<!DOCTYPE[^>\\[]*(?:\\[.*?])?\\s*>"
                    + "|<(/?)([^\\s/>]+)((?:\\s+[^\\s=]+\\s*=\\s*(?:\"[^\"]*\"|'[^']*'))*)\\s*(/?)>",
            Pattern.DOTALL);
    private static final Pattern ATTRIBUTE = Pattern.compile("([^\\s=]+)\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)')");

    private final List<Element> elements = new ArrayList<>();

    /**
     * An element. Offsets are those of the text; it ends where its end tag does.
     *
     * @param firstLine of its start tag
     * @param lastLine of its start tag
     * @param attributes by their names as written
     */
    record Element(
            String name,
            @Nullable Element parent,
            int from,
            int tagEnd,
            End end,
            boolean isEmpty,
            int firstLine,
            int lastLine,
            Map<String, Value> attributes) {
        /** The decoded value; empty if there is none. */
        String value(String attribute) {
            Value value = attributes.get(attribute);
            return value == null ? "" : value.decoded();
        }

        int to() {
            return end.to;
        }
    }

    /** Where an element's end tag is; of an element without contents, where the element ends. */
    static final class End {
        private int from;
        private int to;

        End(int at) {
            set(at, at);
        }

        private void set(int begin, int behind) {
            from = begin;
            to = behind;
        }

        int from() {
            return from;
        }
    }

    /** The value of an attribute, without its quotation marks. */
    record Value(String raw, int from, int to) {
        String decoded() {
            return raw.replace("&lt;", "<")
                    .replace("&gt;", ">")
                    .replace("&quot;", "\"")
                    .replace("&apos;", "'")
                    .replace("&amp;", "&");
        }
    }

    XmlTags(String text) {
        Deque<Element> open = new ArrayDeque<>();
        Matcher tag = TAG.matcher(text);
        int line = 1;
        int counted = 0;
        while (tag.find()) {
            if (tag.group(2) == null) {
                continue;
            }
            line += lines(text, counted, tag.start());
            counted = tag.start();
            if (!tag.group(1).isEmpty()) {
                Element closed = open.poll();
                if (closed != null) {
                    closed.end().set(tag.start(), tag.end());
                }
                continue;
            }
            boolean isEmpty = !tag.group(4).isEmpty();
            Element element = new Element(
                    local(tag.group(2)),
                    open.peek(),
                    tag.start(),
                    tag.end(),
                    new End(tag.end()),
                    isEmpty,
                    line,
                    line + lines(text, tag.start(), tag.end()),
                    attributes(tag.group(3), tag.start(3)));
            elements.add(element);
            if (!isEmpty) {
                open.push(element);
            }
        }
    }

    private static String local(String name) {
        return name.substring(name.indexOf(':') + 1);
    }

    private static int lines(String text, int from, int to) {
        return (int) text.substring(from, to)
                .chars()
                .filter(letter -> letter == '\n')
                .count();
    }

    private static Map<String, Value> attributes(String text, int offset) {
        Map<String, Value> attributes = new LinkedHashMap<>();
        Matcher each = ATTRIBUTE.matcher(text);
        while (each.find()) {
            int group = each.group(2) == null ? 3 : 2;
            attributes.put(
                    each.group(1), new Value(each.group(group), offset + each.start(group), offset + each.end(group)));
        }
        return attributes;
    }

    List<Element> elements() {
        return elements;
    }
}
