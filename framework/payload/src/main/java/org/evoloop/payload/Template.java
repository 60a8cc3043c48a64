package org.evoloop.payload;

import java.math.BigDecimal;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.evoloop.evolution.Values;
import tools.jackson.core.io.JsonStringEncoder;

/**
 * A message with places for an event's values: {@code {"degrees": ${degrees}}}. A value in a JSON message stays a value:
 * a text is escaped between quotation marks, and gets them elsewhere.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Template {
    private static final Pattern PLACE = Pattern.compile("\\$\\{([A-Za-z_][A-Za-z0-9_.-]*)}");

    private final String text;
    private final List<Place> places;

    /** How a value is written at its place. */
    private enum Form {
        PLAIN,
        JSON,
        IN_JSON_STRING,
        IN_URL
    }

    private record Place(int start, int end, String name, Form form) {}

    private Template(String text, List<Place> places) {
        this.text = text;
        this.places = places;
    }

    /** A message. */
    public static Template of(String text) {
        // A digit keeps the message valid whether it stands for a number or in a string.
        boolean json =
                PLACE.matcher(text).find() && Part.isJson(PLACE.matcher(text).replaceAll("0"));
        return parse(text, start -> !json ? Form.PLAIN : isInString(text, start) ? Form.IN_JSON_STRING : Form.JSON);
    }

    /** A URL, in which values are percent-encoded. */
    public static Template url(String text) {
        return parse(text, start -> Form.IN_URL);
    }

    private static Template parse(String text, IntFunction<Form> form) {
        List<Place> places = new ArrayList<>();
        for (MatchResult each : PLACE.matcher(text).results().toList()) {
            places.add(new Place(each.start(), each.end(), each.group(1), form.apply(each.start())));
        }
        return new Template(text, List.copyOf(places));
    }

    private static boolean isInString(String json, int end) {
        boolean inside = false;
        for (int at = 0; at < end; at++) {
            if (inside && json.charAt(at) == '\\') {
                at++;
            } else if (json.charAt(at) == '"') {
                inside = !inside;
            }
        }
        return inside;
    }

    /** The names of the values that it needs. */
    public Set<String> names() {
        Set<String> names = new LinkedHashSet<>();
        places.forEach(place -> names.add(place.name()));
        return names;
    }

    /**
     * The message with these values.
     *
     * @throws IllegalArgumentException if one is missing
     */
    public String with(Values values) {
        if (places.isEmpty()) {
            return text;
        }
        StringBuilder filled = new StringBuilder();
        int from = 0;
        for (Place place : places) {
            Object value = values.byName().get(place.name());
            if (value == null) {
                throw new IllegalArgumentException("the event carries no " + place.name()
                        + (values.isEmpty() ? "" : ", only " + values) + ", which the message needs");
            }
            filled.append(text, from, place.start()).append(written(value, place.form()));
            from = place.end();
        }
        return filled.append(text.substring(from)).toString();
    }

    private static String written(Object value, Form form) {
        String plain = value instanceof Double number && Double.isFinite(number)
                ? BigDecimal.valueOf(number).stripTrailingZeros().toPlainString()
                : value.toString();
        return switch (form) {
            case PLAIN -> plain;
            case JSON -> value instanceof String ? "\"" + escaped(plain) + "\"" : plain;
            case IN_JSON_STRING -> escaped(plain);
            case IN_URL -> URLEncoder.encode(plain, StandardCharsets.UTF_8).replace("+", "%20");
        };
    }

    private static String escaped(String text) {
        return new String(JsonStringEncoder.getInstance().quoteAsCharArray(text));
    }

    /** As it was given. */
    @Override
    public String toString() {
        return text;
    }
}
