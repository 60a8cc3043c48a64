package org.evoloop.payload;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonPointer;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * A part of a message: all of it, the value at a JSON pointer, or what a pattern finds in one of these.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Part {
    /** All of it. */
    public static final Part WHOLE = new Part(null, null);

    private static final JsonFactory JSON = new JsonFactory();

    private final @Nullable JsonPointer pointer;
    private final @Nullable Pattern pattern;

    private Part(@Nullable JsonPointer pointer, @Nullable Pattern pattern) {
        this.pointer = pointer;
        this.pattern = pattern;
    }

    /**
     * The text, number or boolean at a JSON pointer (RFC 6901).
     *
     * @param pointer such as {@code /state} or {@code /items/0/name}
     * @throws IllegalArgumentException if it does not begin with a slash
     */
    public static Part at(String pointer) {
        if (!pointer.startsWith("/")) {
            throw new IllegalArgumentException("'" + pointer + "' is not a JSON pointer; write one such as /state");
        }
        return new Part(JsonPointer.compile(pointer), null);
    }

    /**
     * What the first group of a pattern finds in this part, if all of the part matches.
     *
     * @throws IllegalArgumentException if the pattern has no group
     */
    public Part group(Pattern with) {
        if (with.matcher("").groupCount() == 0) {
            throw new IllegalArgumentException("the pattern '" + with + "' has no group; put the value in parentheses");
        }
        return new Part(pointer, with);
    }

    /** The part of a message, as text; empty if there is none, or the message is not JSON and should be. */
    public Optional<String> in(String message) {
        Optional<String> text = pointer == null ? Optional.of(message) : value(message, pointer);
        return pattern == null
                ? text
                : text.flatMap(whole -> {
                    Matcher match = pattern.matcher(whole);
                    return match.matches() ? Optional.ofNullable(match.group(1)) : Optional.empty();
                });
    }

    /** Whether a message is a JSON object or array. */
    static boolean isJson(String message) {
        try (JsonParser json = JSON.createParser(ObjectReadContext.empty(), message)) {
            JsonToken first = json.nextToken();
            return first != null && first.isStructStart() && endsAfter(json.skipChildren());
        } catch (JacksonException malformed) {
            return false;
        }
    }

    private static Optional<String> value(String message, JsonPointer pointer) {
        try (JsonParser json = JSON.createParser(ObjectReadContext.empty(), message)) {
            json.nextToken();
            String value = find(json, pointer);
            return endsAfter(json) ? Optional.ofNullable(value) : Optional.empty();
        } catch (JacksonException malformed) {
            return Optional.empty();
        }
    }

    /** Whether nothing follows the value just read, so that the message is JSON to its end. */
    private static boolean endsAfter(JsonParser json) {
        return json.nextToken() == null;
    }

    /** The value at a pointer into the value that begins here; reads all of that value. The last of two counts. */
    private static @Nullable String find(JsonParser json, JsonPointer pointer) {
        if (pointer.matches()) {
            JsonToken token = json.currentToken();
            boolean scalar = token != null && token.isScalarValue() && token != JsonToken.VALUE_NULL;
            String value = scalar ? json.getString() : null;
            json.skipChildren();
            return value;
        }
        String found = null;
        boolean object = json.currentToken() == JsonToken.START_OBJECT;
        if (object || json.currentToken() == JsonToken.START_ARRAY) {
            for (int index = 0; !isEnd(json.nextToken()); index++) {
                boolean leads = object
                        ? pointer.matchesProperty(String.valueOf(json.currentName()))
                        : pointer.matchesElement(index);
                if (object) {
                    json.nextToken();
                }
                if (leads) {
                    found = find(json, pointer.tail());
                } else {
                    json.skipChildren();
                }
            }
        }
        return found;
    }

    private static boolean isEnd(@Nullable JsonToken token) {
        return token == null || token.isStructEnd();
    }

    /** For messages: {@code /state}, or {@code its text}. */
    @Override
    public String toString() {
        return (pointer == null ? "its text" : pointer.toString()) + (pattern == null ? "" : " by " + pattern);
    }
}
