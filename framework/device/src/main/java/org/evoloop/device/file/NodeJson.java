package org.evoloop.device.file;

import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.payload.JsonObject;

/**
 * A part of a device file as JSON: what is written without quotes is a number or a truth if it looks like one.
 *
 * <p>Threading: pure functions, which any thread may call.
 *
 * @since 0.1
 */
public final class NodeJson {
    private static final Pattern PLAIN =
            Pattern.compile("true|false|-?(0|[1-9][0-9]{0,14})(\\.[0-9]{1,15})?|\\$\\{[A-Za-z_][A-Za-z0-9_.-]*}");

    private NodeJson() {}

    /** The JSON text of this part. */
    public static String of(Node node) {
        if (node instanceof Node.Entries mapping) {
            return mapping.entries().entrySet().stream()
                    .map(entry -> quoted(entry.getKey().value()) + ":" + of(entry.getValue()))
                    .collect(Collectors.joining(",", "{", "}"));
        }
        if (node instanceof Node.Items list) {
            return list.items().stream().map(NodeJson::of).collect(Collectors.joining(",", "[", "]"));
        }
        Node.Text text = (Node.Text) node;
        return text.plain() && PLAIN.matcher(text.value()).matches()
                ? text.value()
                : text.isMissing() ? "null" : quoted(text.value());
    }

    private static String quoted(String text) {
        String object = new JsonObject().put("", text).toString();
        return object.substring("{\"\":".length(), object.length() - 1);
    }
}
