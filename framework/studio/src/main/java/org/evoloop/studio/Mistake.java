package org.evoloop.studio;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;

/**
 * Why a text is no model.
 *
 * @param path of the file
 * @param line from 1; 1 if it is not known
 * @param column from 1; 1 if it is not known
 */
public record Mistake(String path, int line, int column, String message) {
    private static final Pattern OF_MACHINE = Pattern.compile("(?s).*? has (?:a problem|\\d+ problems):\\s*(\\S.*)");
    private static final Pattern PLACED = Pattern.compile("line (\\d{1,9})(?:, [^:]*)?: (?:column (\\d{1,9}): )?(.*)");
    private static final Pattern OF_FILE = Pattern.compile("(?s).*?\\bline (\\d{1,9})(?:,? column (\\d{1,9}))?\\b.*");

    /**
     * What a reader of models reports, each of whose messages begins with the file; at least one.
     *
     * @param path of the file
     */
    public static List<Mistake> all(String path, ModelException reported) {
        String message = String.valueOf(reported.getMessage());
        Matcher machine = OF_MACHINE.matcher(message);
        String problems = machine.matches() ? machine.group(1) : message;
        return problems.lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .map(line -> one(path, line))
                .toList();
    }

    private static Mistake one(String path, String text) {
        String plain = text.startsWith(path) ? text.substring(path.length()).replaceFirst("^[:,] *", "") : text;
        Matcher placed = PLACED.matcher(plain);
        if (placed.matches()) {
            return new Mistake(path, number(placed.group(1)), number(placed.group(2)), placed.group(3));
        }
        Matcher file = OF_FILE.matcher(plain);
        return file.matches()
                ? new Mistake(path, number(file.group(1)), number(file.group(2)), plain)
                : new Mistake(path, 1, 1, plain);
    }

    private static int number(@Nullable String digits) {
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
