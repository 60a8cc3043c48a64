package org.evoloop.fleet.wire;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Order;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A record read from a fleet's topics. Unknown members are ignored.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Reading {
    private static final JsonMapper MAPPER = new JsonMapper();

    private final JsonNode record;

    private Reading(JsonNode record) {
        this.record = record;
    }

    /**
     * Reads a record.
     *
     * @throws Refusal if it is not a JSON object, or one of a newer schema
     */
    public static Reading of(byte @Nullable [] bytes) {
        JsonNode node;
        try {
            node = bytes == null ? null : MAPPER.readTree(bytes);
        } catch (JacksonException e) {
            throw malformed("it is not valid JSON: " + e.getOriginalMessage());
        }
        if (node == null || !node.isObject()) {
            throw malformed("a JSON object was expected");
        }
        Reading reading = new Reading(node);
        long schema = reading.number("schema", 1);
        if (schema > Wire.SCHEMA) {
            throw new Refusal(
                    Refusal.Reason.NEWER_SCHEMA,
                    "its schema is " + schema + ", this program supports " + Wire.SCHEMA + "; update it first");
        } else if (schema < 1) {
            throw malformed("its schema is " + schema + ", which does not exist");
        }
        return reading;
    }

    /** The occurrence in this record of {@link Topic#OCCURRENCES}. */
    public Occurrence occurrence() {
        long at = Wire.nanos(number("atMillis"));
        String kind = record.has("kind") ? text("kind") : "heard";
        try {
            return switch (kind) {
                case "found" -> new Occurrence.Found(new State(text("state")), at);
                case "asked" -> new Occurrence.Asked(new Event(text("event")), values(), visit(), at);
                case "heard" ->
                    new Occurrence.Heard(
                            new Event(text("event")), values(), source(), truth("deviceActed"), holding(), visit(), at);
                default ->
                    throw malformed(
                            "'" + kind + "' is not a kind of occurrence; the kinds are heard, found " + "and asked");
            };
        } catch (ModelException | IllegalArgumentException e) {
            throw malformed(String.valueOf(e.getMessage()));
        }
    }

    /** The answer in this record of {@link Topic#EFFECTS}. */
    public Answer answer() {
        String state = record.has("state") ? text("state") : null;
        return new Answer(
                number("sequence"),
                constant(Answer.Outcome.values(), "outcome"),
                record.has("reason") ? text("reason") : "",
                state == null ? null : new State(state),
                Wire.nanos(number("atMillis")));
    }

    /** The order in this record of {@link Topic#COMMANDS}. */
    public Order order() {
        Order.Kind kind = constant(Order.Kind.values(), "kind");
        String what = kind == Order.Kind.LOCATE ? "" : text(kind == Order.Kind.SEND ? "event" : "effect");
        return new Order(
                number("sequence"),
                0,
                kind,
                what,
                values(),
                Wire.nanos(number("deadlineMillis")),
                number("visit", 0),
                truth("function"),
                text("from", ""),
                text("to", ""));
    }

    private Source source() {
        Source source = record.has("source") ? constant(Source.values(), "source") : Source.CONTROLLER;
        if (source == Source.TIMER) {
            throw malformed("the source 'timer' is reserved for the fleet's own timers");
        }
        return source;
    }

    private <E extends Enum<E>> E constant(E[] all, String name) {
        String word = text(name);
        for (E each : all) {
            if (Wire.word(each).equals(word)) {
                return each;
            }
        }
        throw malformed("'" + word + "' is no " + name);
    }

    private long visit() {
        return record.has("visit") ? number("visit") : Occurrence.ANY_VISIT;
    }

    private Set<String> holding() {
        JsonNode node = record.get("holding");
        Set<String> holding = new HashSet<>();
        if (node != null) {
            node.forEach(each -> holding.add(each.asString()));
        }
        return holding;
    }

    private Values values() {
        JsonNode node = record.get("values");
        if (node == null || node.isEmpty()) {
            return Values.NONE;
        }
        Map<String, Object> values = new HashMap<>();
        node.properties().forEach(each -> {
            JsonNode value = each.getValue();
            values.put(
                    each.getKey(),
                    value.isNumber()
                            ? (Object) value.doubleValue()
                            : value.isBoolean() ? (Object) value.booleanValue() : value.asString());
        });
        return new Values(values);
    }

    /** The number of that name. */
    public long number(String name) {
        JsonNode node = record.get(name);
        if (node == null || !node.canConvertToLong()) {
            throw malformed("'" + name + "' must be a whole number");
        }
        return node.longValue();
    }

    /** The number of that name; {@code otherwise} if there is none. */
    public long number(String name, long otherwise) {
        return record.has(name) ? number(name) : otherwise;
    }

    /** The number of that name, possibly with a fraction; {@code otherwise} if there is none. */
    public double fraction(String name, double otherwise) {
        JsonNode node = record.get(name);
        if (node == null) {
            return otherwise;
        } else if (!node.isNumber()) {
            throw malformed("'" + name + "' must be a number");
        }
        return node.doubleValue();
    }

    /** The text of that name. */
    public String text(String name) {
        JsonNode node = record.get(name);
        if (node == null || !node.isString()) {
            throw malformed("'" + name + "' must be a string");
        }
        return node.stringValue();
    }

    /** The text of that name; {@code otherwise} if there is none. */
    public String text(String name, String otherwise) {
        return record.has(name) ? text(name) : otherwise;
    }

    private boolean truth(String name) {
        JsonNode node = record.get(name);
        return node != null && node.booleanValue();
    }

    /** The object of that name. */
    public Optional<Reading> inner(String name) {
        return Optional.ofNullable(record.get(name)).map(Reading::new);
    }

    /** The objects of that name, a list; none if there is no such list. */
    public List<Reading> each(String name) {
        JsonNode node = record.get(name);
        return node == null ? List.of() : node.valueStream().map(Reading::new).toList();
    }

    /** The texts of that name, a list; null if there is no such list. */
    public @Nullable List<String> texts(String name) {
        JsonNode node = record.get(name);
        return node == null ? null : node.valueStream().map(JsonNode::asString).toList();
    }

    private static Refusal malformed(String detail) {
        return new Refusal(Refusal.Reason.MALFORMED, detail);
    }
}
