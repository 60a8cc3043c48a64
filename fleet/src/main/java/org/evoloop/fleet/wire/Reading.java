package org.evoloop.fleet.wire;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Order;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
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
    /** The characters of the longest name of an event, a state, a guard, an effect or a value. */
    private static final int LONGEST_NAME = 1_000;

    /** Nanoseconds since 1970 fit in a long until the year 2262. */
    private static final long MOST_MILLIS = Wire.millis(Long.MAX_VALUE);

    private static final Source[] SOURCES = Source.values();
    private static final Answer.Outcome[] OUTCOMES = Answer.Outcome.values();
    private static final Order.Kind[] KINDS = Order.Kind.values();

    private final JsonRecord record;

    private Reading(JsonRecord record) {
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
        JsonRecord record = ofAnySchema(bytes);
        if (!record.has("schema")) {
            throw malformed("it has no schema; write \"schema\":" + Wire.SCHEMA);
        }
        long schema = record.number("schema");
        if (schema > newest) {
            throw new Refusal(
                    Refusal.Reason.NEWER_SCHEMA,
                    "its schema is " + schema + ", this program supports " + newest + "; update it first");
        } else if (schema < 1) {
            throw malformed("its schema is " + schema + ", which does not exist");
        }
        return new Reading(record);
    }

    /**
     * Reads a record of any schema, or of none.
     *
     * @throws Refusal if it is not a JSON object
     */
    public static JsonRecord ofAnySchema(byte @Nullable [] bytes) {
        if (bytes == null) {
            throw malformed("a JSON object was expected");
        }
        return JsonRecord.of(bytes, Reading::malformed);
    }

    /** Its members. Mistakes in them are refusals, too. */
    public JsonRecord record() {
        return record;
    }

    /** The occurrence in this record of {@link Topic#OCCURRENCES}. */
    public Occurrence occurrence() {
        long at = time("atMillis");
        String kind = record.text("kind", "heard");
        try {
            return switch (kind) {
                case "found" -> new Occurrence.Found(new State(name("state")), at);
                case "asked" -> new Occurrence.Asked(new Event(name("event")), values(), visit(), at);
                case "heard" ->
                    new Occurrence.Heard(
                            new Event(name("event")),
                            values(),
                            source(),
                            record.truth("deviceActed"),
                            holding(),
                            visit(),
                            at);
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
                    record.number("sequence"),
                    constant(OUTCOMES, "outcome"),
                    record.text("reason", ""),
                    !record.has("state") ? null : new State(name("state")),
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
                record.number("sequence"),
                0,
                kind,
                what,
                values(),
                time("deadlineMillis"),
                record.number("visit", 0),
                record.truth("function"),
                sends ? record.text("from", "") : "",
                sends ? record.text("to", "") : "");
    }

    /** The dead letter in this record of {@link Topic#DEAD_LETTERS}; nothing if it is a mark. */
    public Optional<DeadLetter> deadLetter() {
        return !record.has("resent") ? Optional.of(DeadLetter.read(record)) : Optional.empty();
    }

    /** The mark in this record of {@link Topic#DEAD_LETTERS}; nothing if it is a letter. */
    public Optional<Resent> resent() {
        return !record.has("resent")
                ? Optional.empty()
                : Optional.of(new Resent(name("resent"), record.number("before")));
    }

    private Source source() {
        Source source = !record.has("source") ? Source.CONTROLLER : constant(SOURCES, "source");
        if (source == Source.TIMER) {
            throw malformed("the source 'timer' is reserved for the fleet's own timers");
        }
        return source;
    }

    private <E extends Enum<E>> E constant(E[] all, String name) {
        String word = record.text(name);
        for (E each : all) {
            if (JsonObject.word(each).equals(word)) {
                return each;
            }
        }
        throw malformed("'" + word + "' is no " + name);
    }

    private long visit() {
        return record.number("visit", Occurrence.ANY_VISIT);
    }

    private Set<String> holding() {
        List<String> texts = record.texts("holding");
        texts.forEach(guard -> requireShort("a guard in 'holding'", guard));
        return Set.copyOf(texts);
    }

    private Values values() {
        Values values = record.values("values");
        values.byName().keySet().forEach(name -> requireShort("the name of a value", name));
        return values;
    }

    private long time(String name) {
        long millis = record.number(name);
        if (millis > MOST_MILLIS || millis < -MOST_MILLIS) {
            throw malformed("'" + name + "' is " + millis + "; give milliseconds since 1970");
        }
        return Wire.nanos(millis);
    }

    /** The text of that name, which is the name of something. */
    public String name(String name) {
        return requireShort("'" + name + "'", record.text(name));
    }

    private static String requireShort(String what, String name) {
        if (name.length() > LONGEST_NAME) {
            throw malformed(what + " has " + name.length() + " characters, allowed are " + LONGEST_NAME);
        }
        return name;
    }

    private static Refusal malformed(String detail) {
        return new Refusal(Refusal.Reason.MALFORMED, detail);
    }
}
