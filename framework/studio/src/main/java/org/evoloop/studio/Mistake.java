package org.evoloop.studio;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.ModelException;

/**
 * Why a text is no model.
 *
 * @param path of the file
 * @param line from 1; 1 if it is not known
 * @param column from 1; 1 if it is not known
 */
public record Mistake(String path, int line, int column, String message) {
    private static final String PLACE = "line (\\d{1,9})(?:, (?:column (\\d{1,9})|id [^:]*))?";
    private static final Pattern OF_MACHINE =
            Pattern.compile("(?s).*? has (?:a problem|\\d+ problems):\\s*" + PLACE + ": (?:column (\\d{1,9}): )?(.*)");
    private static final Pattern OF_FILE = Pattern.compile("(?s)(.*?)\\(?" + PLACE + "\\)?(.*)");

    /** The first mistake that a reader of models reports, whose message begins with the file. */
    static Mistake of(String path, ModelException reported) {
        String message = String.valueOf(reported.getMessage());
        String plain = message.startsWith(path + ": ") ? message.substring(path.length() + 2) : message;
        Matcher machine = OF_MACHINE.matcher(plain);
        if (machine.matches()) {
            String first = machine.group(4).lines().findFirst().orElse("");
            return new Mistake(path, number(machine.group(1)), number(machine.group(3)), first);
        }
        Matcher file = OF_FILE.matcher(plain);
        return file.matches()
                ? new Mistake(path, number(file.group(2)), number(file.group(3)), plain)
                : new Mistake(path, 1, 1, plain);
    }

    private static int number(String digits) {
        return digits == null ? 1 : Integer.parseInt(digits);
    }

    /** As the page expects it. */
    public JsonObject json() {
        return new JsonObject()
                .put("path", path)
                .put("line", line)
                .put("column", column)
                .put("message", message);
    }
}
