package org.evoloop.fleet.wire;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.engine.Output;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.DeviceState;
import org.evoloop.fleet.device.Order;
import org.evoloop.mqtt.edge.EdgeRecords;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Writes the records of a fleet's topics.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Wire {
    /** The version of the schemas that is written, and the newest that is read. */
    public static final int SCHEMA = EdgeRecords.SCHEMA;

    private static final long NANOS_PER_MILLI = 1_000_000;

    /** Leaves room for the key within the megabyte that brokers and producers take by default. */
    private static final int LARGEST = 1_000_000;

    private static final int MOST_RECORD = 500_000;
    private static final int MOST_DETAIL = 1_000;

    private Wire() {}

    /** A time as it is written in records: milliseconds since 1970. */
    public static long millis(long nanos) {
        return Math.floorDiv(nanos, NANOS_PER_MILLI);
    }

    /** A time read from a record, in nanoseconds since 1970. */
    public static long nanos(long millis) {
        return millis * NANOS_PER_MILLI;
    }

    static JsonObject record(int schema) {
        return new JsonObject().put("schema", schema);
    }

    /** For {@link Topic#DEVICES}. */
    public static byte[] device(String model) {
        return record(SCHEMA).put("model", model).toBytes();
    }

    /**
     * For {@link Topic#OCCURRENCES}; {@code number} is the gateway's sequence number for this device, 0 if it does not
     * number its records.
     */
    public static byte[] occurrence(Occurrence occurrence, long number) {
        JsonObject record = EdgeRecords.occurrence(occurrence, millis(occurrence.observedNanos()));
        return (number > 0 ? record.put("number", number) : record).toBytes();
    }

    /** For {@link Topic#EFFECTS}. */
    public static byte[] effect(Answer answer) {
        return EdgeRecords.effect(
                        answer.sequence(), answer.outcome(), answer.reason(), answer.state(), millis(answer.atNanos()))
                .toBytes();
    }

    /** For {@link Topic#COMMANDS}. */
    public static byte[] command(Order order) {
        JsonObject json = record(SCHEMA)
                .put("sequence", order.sequence())
                .put("kind", JsonObject.word(order.kind()))
                .put("deadlineMillis", millis(order.deadlineNanos()));
        if (order.kind() == Order.Kind.SEND) {
            json.put("event", order.what()).put("from", order.from()).put("to", order.to());
        } else if (order.kind() == Order.Kind.RUN) {
            json.put("effect", order.what());
        }
        json.put("visit", order.visit()).put("function", order.function());
        return json.putSome("values", order.values().byName()).toBytes();
    }

    /** For {@link Topic#DECISIONS}; null if the notice is not published. */
    public static byte @Nullable [] decision(String model, Output.Notice notice) {
        if (notice instanceof Output.Ended ended) {
            return occurrence(model, JsonObject.word(ended.outcome()), ended.occurrence())
                    .put("before", states(ended.before()))
                    .put("after", states(ended.after()))
                    .putSome("detail", ended.detail())
                    .toBytes();
        } else if (notice instanceof Output.Dropped dropped) {
            return occurrence(model, "dropped", dropped.occurrence()).toBytes();
        } else if (notice instanceof Output.Refused refused) {
            return occurrence(model, "refused", refused.occurrence()).toBytes();
        } else if (notice instanceof Output.Doubted doubted) {
            return record(SCHEMA)
                    .put("model", model)
                    .put("outcome", doubted.why().isEmpty() ? "sure" : "in-doubt")
                    .putSome("detail", doubted.why())
                    .toBytes();
        } else if (notice instanceof Output.Evolved evolved) {
            return record(SCHEMA)
                    .put("model", model)
                    .put("outcome", "evolved")
                    .put("before", states(evolved.before()))
                    .put("after", states(evolved.fate().at()))
                    .toBytes();
        }
        return null;
    }

    private static JsonObject occurrence(String model, String outcome, Occurrence occurrence) {
        return record(SCHEMA)
                .put("model", model)
                .put("outcome", outcome)
                .put("occurrence", occurrence.label())
                .put("source", JsonObject.word(occurrence.source()))
                .put("atMillis", millis(occurrence.observedNanos()));
    }

    private static JsonObject states(Configuration at) {
        return new JsonObject()
                .put("device", at.original().name())
                .put("system", at.evolved().name());
    }

    /** For {@link Topic#STATES}. */
    public static byte[] state(DeviceState state, boolean isNew) {
        Snapshot snapshot = state.snapshot();
        JsonObject json = record(SCHEMA)
                .put("model", state.model())
                .put("device", snapshot.at().original().name())
                .put("system", snapshot.at().evolved().name())
                .put("visit", snapshot.visit().number())
                .put(
                        "function",
                        isNew && !snapshot.visit().over() && !snapshot.visit().startOwed());
        Transition by = snapshot.visit().by();
        if (isNew && by != null) {
            json.put("from", by.source().name()).put("by", by.event().toString());
        }
        json.put("sequence", state.sequence())
                .put("settled", state.open() == null && !snapshot.visit().over());
        Map<Event, Long> deadlines = snapshot.visit().deadlines();
        if (!deadlines.isEmpty()) {
            Map<String, Long> sorted = new TreeMap<>();
            deadlines.forEach((timer, due) -> sorted.put(timer.name(), millis(due)));
            json.putSome("timersMillis", sorted);
        }
        return snapshot.doubt() == null || snapshot.doubt().settled()
                ? json.toBytes()
                : json.put("inDoubt", snapshot.doubt().why()).toBytes();
    }

    /** For {@link Topic#DEAD_LETTERS}; a large record is cut, so that the letter can be sent. */
    public static byte[] deadLetter(
            Refusal refusal, String topic, int partition, long offset, byte @Nullable [] record) {
        byte[] whole = record == null ? new byte[0] : record;
        byte[] shown = whole.length > MOST_RECORD ? Arrays.copyOf(whole, MOST_RECORD) : whole;
        JsonObject json = record(SCHEMA)
                .put("reason", JsonObject.word(refusal.reason()))
                .put("detail", cut(refusal.detail(), MOST_DETAIL))
                .put("topic", topic)
                .put("partition", partition)
                .put("offset", offset)
                .put("record", Base64.getEncoder().encodeToString(shown));
        return (shown.length == whole.length ? json : json.put("bytes", whole.length)).toBytes();
    }

    /** The first {@code most} characters of {@code text}. */
    public static String cut(String text, int most) {
        return text.length() > most ? text.substring(0, most) : text;
    }

    /**
     * Returns {@code record} unless it is larger than brokers take by default: an instance could not go on with the records
     * that come after it.
     *
     * @param what what the record is, for people
     * @throws Refusal if it is larger
     */
    public static byte[] requireSendable(byte[] record, String what) {
        if (record.length > LARGEST) {
            throw new Refusal(
                    Refusal.Reason.TOO_LARGE, what + " would have " + record.length + " bytes, allowed are " + LARGEST);
        }
        return record;
    }

    /** The text of {@code record}, for logs and tables. */
    public static String text(byte[] record) {
        return new String(record, StandardCharsets.UTF_8);
    }
}
