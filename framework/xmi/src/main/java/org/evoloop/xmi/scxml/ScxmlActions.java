package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.xmi.dialect.XmlNode;

/** Executable content as texts, one per element; the converter's author binds them to code. */
final class ScxmlActions {
    private ScxmlActions() {}

    /**
     * All actions in {@code onentry}, {@code onexit}, {@code transition} and the like, in order; a {@code target}
     * element is not an action.
     */
    static List<String> in(XmlNode block) {
        if (block.children().isEmpty()) {
            return List.of();
        }
        List<String> texts = new ArrayList<>();
        for (XmlNode action : block.children()) {
            if (!ScxmlVocabulary.isEditors(action) && !action.name().equals("target")) {
                texts.add(text(action));
            }
        }
        return texts;
    }

    /** The initial values of a data model. */
    static List<String> data(XmlNode datamodel) {
        return datamodel.children("data").stream().map(ScxmlActions::text).toList();
    }

    /** {@code x = 1}, {@code raise e}, {@code log(expr='x')}, {@code if(cond='x') {...}}. */
    static String text(XmlNode action) {
        return switch (action.name()) {
            case "assign" -> assignment(action, first(action, "location", "name"));
            case "data" -> assignment(action, first(action, "id", "name"));
            case "script" -> action.attribute("src").isEmpty() ? action.text() : call(action);
            case "raise" -> "raise " + action.attribute("event");
            default -> call(action);
        };
    }

    private static String assignment(XmlNode action, String variable) {
        String value = first(action, "expr", "src");
        return variable + (value.isEmpty() ? body(action) : " = " + value);
    }

    private static String first(XmlNode action, String one, String other) {
        return action.attribute(one).isEmpty() ? action.attribute(other) : action.attribute(one);
    }

    private static String call(XmlNode action) {
        String arguments = action.attributeNames().stream()
                .map(name -> name + "='" + action.attribute(name) + "'")
                .collect(Collectors.joining(", ", "(", ")"));
        return action.name() + (arguments.equals("()") ? "" : arguments) + body(action);
    }

    private static String body(XmlNode action) {
        String body = Stream.concat(
                        Stream.of(action.text()), action.children().stream().map(ScxmlActions::text))
                .filter(text -> !text.isEmpty())
                .collect(Collectors.joining("; "));
        return body.isEmpty() ? "" : " {" + body + "}";
    }
}
