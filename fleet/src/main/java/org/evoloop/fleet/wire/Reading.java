package org.evoloop.fleet.wire;

import java.util.ArrayList;
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

/**
 * A record read from a fleet's topics. Unknown members are ignored.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Reading {
    /** Whole doubles of a smaller magnitude fit in a long. */
    private static final double MOST_WHOLE = 0x1p63;

    /** The characters of the longest name of an event, a state, a guard, an effect or a value. */
    private static final int LONGEST_NAME = 1_000;

    /** Nanoseconds since 1970 fit in a long until the year 2262. */
    private static final long MOST_MILLIS = Wire.millis(Long.MAX_VALUE);

    private static final Source[] SOURCES = Source.values();
    private static final Answer.Outcome[] OUTCOMES = Answer.Outcome.values();
    private static final Order.Kind[] KINDS = Order.Kind.values();

    private final Members record;

    private Reading(Members record) {
        this.record = record;
    }

    /**
     * Reads a record.
     *
     * @throws Refusal if it is not a JSON object, or one without a schema or of a newer one
     */
    public static Reading of(byte @Nullable [] bytes) {
        return of(bytes, Wire.SCHEMA);
    }

    /**
     * As the other method.
     *
     * @param newest the newest schema that is understood
     */
    static Reading of(byte @Nullable [] bytes, int newest) {
        Reading reading = ofAnySchema(bytes);
        Object written = reading.record.get("schema");
        if (written == null || written == Members.NULL) {
            throw malformed("it has no schema; write \"schema\":" + Wire.SCHEMA);
        }
        long schema = reading.number("schema");
        if (schema > newest) {
            throw new Refusal(
                    Refusal.Reason.NEWER_SCHEMA,
                    "its schema is " + schema + ", this program supports " + newest + "; update it first");
        } else if (schema < 1) {
            throw malformed("its schema is " + schema + ", which does not exist");
        }
        return reading;
    }

    /**
     * Reads a record of any schema, or of none.
     *
     * @throws Refusal if it is not a JSON object
     */
    public static Reading ofAnySchema(byte @Nullable [] bytes) {
        if (bytes == null || !(JsonReader.read(bytes) instanceof Members members)) {
            throw malformed("a JSON object was expected");
        }
        return new Reading(members);
    }

    /** The occurrence in this record of {@link Topic#OCCURRENCES}. */
    public Occurrence occurrence() {
        long at = time("atMillis");
        String kind = text("kind", "heard");
        try {
            return switch (kind) {
                case "found" -> new Occurrence.Found(new State(name("state")), at);
                case "asked" -> new Occurrence.Asked(new Event(name("event")), values(), visit(), at);
                case "heard" ->
                    new Occurrence.Heard(
                            new Event(name("event")), values(), source(), truth("deviceActed"), holding(), visit(), at);
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
        try {
            return new Answer(
                    number("sequence"),
                    constant(OUTCOMES, "outcome"),
                    text("reason", ""),
                    record.get("state") == null ? null : new State(name("state")),
                    time("atMillis"));
        } catch (ModelException e) {
            throw malformed(String.valueOf(e.getMessage()));
        }
    }

    /** The order in this record of {@link Topic#COMMANDS}. */
    public Order order() {
        Order.Kind kind = constant(KINDS, "kind");
        boolean sends = kind == Order.Kind.SEND;
        String what = kind == Order.Kind.LOCATE ? "" : name(sends ? "event" : "effect");
        return new Order(
                number("sequence"),
                0,
                kind,
                what,
                values(),
                time("deadlineMillis"),
                number("visit", 0),
                truth("function"),
                sends ? text("from", "") : "",
                sends ? text("to", "") : "");
    }

    /** The dead letter in this record of {@link Topic#DEAD_LETTERS}; nothing if it is a mark. */
    public Optional<DeadLetter> deadLetter() {
        return record.get("resent") == null ? Optional.of(DeadLetter.read(this)) : Optional.empty();
    }

    /** The mark in this record of {@link Topic#DEAD_LETTERS}; nothing if it is a letter. */
    public Optional<Resent> resent() {
        return record.get("resent") == null
                ? Optional.empty()
                : Optional.of(new Resent(name("resent"), number("before")));
    }

    private Source source() {
        Source source = record.get("source") == null ? Source.CONTROLLER : constant(SOURCES, "source");
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
        return number("visit", Occurrence.ANY_VISIT);
    }

    private Set<String> holding() {
        List<String> texts = texts("holding");
        if (texts == null || texts.isEmpty()) {
            return Set.of();
        }
        texts.forEach(guard -> requireShort("a guard in 'holding'", guard));
        return new HashSet<>(texts);
    }

    private Values values() {
        Members members = members("values");
        if (members == null) {
            return Values.NONE;
        }
        Map<String, Object> values = new HashMap<>();
        members.forEach((name, value) -> {
            requireShort("the name of a value", name);
            if (value instanceof Number number) {
                values.put(name, finite(name, number));
            } else if (value instanceof String || value instanceof Boolean) {
                values.put(name, value);
            } else {
                throw malformed("the value '" + name + "' must be a string, a number or a boolean");
            }
        });
        try {
            return values.isEmpty() ? Values.NONE : new Values(values);
        } catch (IllegalArgumentException e) {
            throw malformed(String.valueOf(e.getMessage()));
        }
    }

    /** JSON cannot express an infinity, so a record with one could not be written again. */
    private static double finite(String name, Number number) {
        double value = number.doubleValue();
        if (Double.isInfinite(value)) {
            throw malformed("the number '" + name + "' is too large; send one of at most 1.7E308, or a string");
        }
        return value;
    }

    private long time(String name) {
        long millis = number(name);
        if (millis > MOST_MILLIS || millis < -MOST_MILLIS) {
            throw malformed("'" + name + "' is " + millis + "; give milliseconds since 1970");
        }
        return Wire.nanos(millis);
    }

    /** The number of that name. */
    public long number(String name) {
        Object value = record.get(name);
        if (value instanceof Long number) {
            return number;
        } else if (value instanceof Double number && number == Math.rint(number) && Math.abs(number) < MOST_WHOLE) {
            return number.longValue();
        }
        throw malformed("'" + name + "' must be a whole number");
    }

    /** The number of that name; {@code otherwise} if there is none. */
    public long number(String name, long otherwise) {
        return record.get(name) == null ? otherwise : number(name);
    }

    /** The number of that name, possibly with a fraction; {@code otherwise} if there is none. */
    public double fraction(String name, double otherwise) {
        Object value = record.get(name);
        if (value == null) {
            return otherwise;
        } else if (value instanceof Number number) {
            return finite(name, number);
        }
        throw malformed("'" + name + "' must be a number");
    }

    /** The text of that name. */
    public String text(String name) {
        if (record.get(name) instanceof String text) {
            return text;
        }
        throw malformed("'" + name + "' must be a string");
    }

    /** The text of that name, which is the name of something. */
    public String name(String name) {
        return requireShort("'" + name + "'", text(name));
    }

    private static String requireShort(String what, String name) {
        if (name.length() > LONGEST_NAME) {
            throw malformed(what + " has " + name.length() + " characters, allowed are " + LONGEST_NAME);
        }
        return name;
    }

    /** The text of that name; {@code otherwise} if there is none. */
    public String text(String name, String otherwise) {
        return record.get(name) == null ? otherwise : text(name);
    }

    private boolean truth(String name) {
        Object value = record.get(name);
        if (value == null || value instanceof Boolean) {
            return Boolean.TRUE.equals(value);
        }
        throw malformed("'" + name + "' must be true or false");
    }

    private @Nullable Members members(String name) {
        Object value = record.get(name);
        if (value == null || value == Members.NULL) {
            return null;
        } else if (value instanceof Members members) {
            return members;
        }
        throw malformed("'" + name + "' must be an object");
    }

    private @Nullable List<?> list(String name) {
        Object value = record.get(name);
        if (value == null || value == Members.NULL) {
            return null;
        } else if (value instanceof List<?> list) {
            return list;
        }
        throw malformed("'" + name + "' must be a list");
    }

    /** The object of that name. */
    public Optional<Reading> inner(String name) {
        return Optional.ofNullable(members(name)).map(Reading::new);
    }

    /** The objects of that name, a list; none if there is no such list. */
    public List<Reading> each(String name) {
        List<?> list = list(name);
        List<Reading> each = new ArrayList<>();
        for (Object value : list == null ? List.of() : list) {
            if (!(value instanceof Members members)) {
                throw malformed("'" + name + "' must be a list of objects");
            }
            each.add(new Reading(members));
        }
        return each;
    }

    /** The texts of that name, a list; null if there is no such list. */
    public @Nullable List<String> texts(String name) {
        List<?> list = list(name);
        if (list == null) {
            return null;
        }
        List<String> texts = new ArrayList<>();
        for (Object value : list) {
            if (!(value instanceof String text)) {
                throw malformed("'" + name + "' must be a list of strings");
            }
            texts.add(text);
        }
        return texts;
    }

    private static Refusal malformed(String detail) {
        return new Refusal(Refusal.Reason.MALFORMED, detail);
    }
}
