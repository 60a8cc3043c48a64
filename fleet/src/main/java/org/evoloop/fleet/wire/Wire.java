package org.evoloop.fleet.wire;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.evoloop.engine.Output;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.DeviceState;
import org.evoloop.fleet.device.Order;
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
    public static final int SCHEMA = 1;

    private static final long NANOS_PER_MILLI = 1_000_000;

    private static final ClassValue<String[]> WORDS = new ClassValue<>() {
        @Override
        protected String[] computeValue(Class<?> type) {
            return Stream.of(type.getEnumConstants())
                    .map(each ->
                            ((Enum<?>) each).name().toLowerCase(Locale.ROOT).replace('_', '-'))
                    .toArray(String[]::new);
        }
    };

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

    /** For {@link Topic#DEVICES}. */
    public static byte[] device(String model) {
        return new Json().with("model", model).bytes();
    }

    /**
     * For {@link Topic#OCCURRENCES}; {@code number} is the gateway's sequence number for this device, 0 if it does not
     * number its records.
     */
    public static byte[] occurrence(Occurrence occurrence, long number) {
        Json json = new Json();
        if (number > 0) {
            json.with("number", number);
        }
        json.with("atMillis", millis(occurrence.observedNanos()));
        if (occurrence instanceof Occurrence.Found found) {
            return json.with("kind", "found")
                    .with("state", found.state().name())
                    .bytes();
        }
        json.with("kind", occurrence instanceof Occurrence.Asked ? "asked" : "heard")
                .with("event", occurrence.label());
        if (occurrence instanceof Occurrence.Heard heard) {
            json.with("source", word(heard.source())).with("deviceActed", heard.deviceActed());
            if (!heard.holding().isEmpty()) {
                json.with("holding", heard.holding().stream().sorted().toList());
            }
        }
        if (occurrence.visit() != Occurrence.ANY_VISIT) {
            json.with("visit", occurrence.visit());
        }
        return json.withValues("values", occurrence.values().byName()).bytes();
    }

    /** For {@link Topic#EFFECTS}. */
    public static byte[] effect(Answer answer) {
        return new Json()
                .with("sequence", answer.sequence())
                .with("outcome", word(answer.outcome()))
                .with("atMillis", millis(answer.atNanos()))
                .withText("reason", answer.reason())
                .withText(
                        "state", answer.state() == null ? null : answer.state().name())
                .bytes();
    }

    /** For {@link Topic#COMMANDS}. */
    public static byte[] command(Order order) {
        Json json = new Json()
                .with("sequence", order.sequence())
                .with("kind", word(order.kind()))
                .with("deadlineMillis", millis(order.deadlineNanos()));
        if (order.kind() == Order.Kind.SEND) {
            json.with("event", order.what()).with("from", order.from()).with("to", order.to());
        } else if (order.kind() == Order.Kind.RUN) {
            json.with("effect", order.what());
        }
        json.with("visit", order.visit()).with("function", order.function());
        return json.withValues("values", order.values().byName()).bytes();
    }

    /** For {@link Topic#DECISIONS}; null if the notice is not published. */
    public static byte @Nullable [] decision(String model, Output.Notice notice) {
        if (notice instanceof Output.Ended ended) {
            Json json = occurrence(model, word(ended.outcome()), ended.occurrence());
            at(json, "before", ended.before());
            return at(json, "after", ended.after())
                    .withText("detail", ended.detail())
                    .bytes();
        } else if (notice instanceof Output.Dropped dropped) {
            return occurrence(model, "dropped", dropped.occurrence()).bytes();
        } else if (notice instanceof Output.Refused refused) {
            return occurrence(model, "refused", refused.occurrence()).bytes();
        } else if (notice instanceof Output.Doubted doubted) {
            return new Json()
                    .with("model", model)
                    .with("outcome", doubted.why().isEmpty() ? "sure" : "in-doubt")
                    .withText("detail", doubted.why())
                    .bytes();
        } else if (notice instanceof Output.Evolved evolved) {
            Json json = new Json().with("model", model).with("outcome", "evolved");
            at(json, "before", evolved.before());
            return at(json, "after", evolved.fate().at()).bytes();
        }
        return null;
    }

    private static Json occurrence(String model, String outcome, Occurrence occurrence) {
        return new Json()
                .with("model", model)
                .with("outcome", outcome)
                .with("occurrence", occurrence.label())
                .with("source", word(occurrence.source()))
                .with("atMillis", millis(occurrence.observedNanos()));
    }

    private static Json at(Json json, String name, Configuration at) {
        return json.begin(name)
                .with("device", at.original().name())
                .with("system", at.evolved().name())
                .end();
    }

    /** For {@link Topic#STATES}. */
    public static byte[] state(DeviceState state, boolean isNew) {
        Snapshot snapshot = state.snapshot();
        Json json = new Json()
                .with("model", state.model())
                .with("device", snapshot.at().original().name())
                .with("system", snapshot.at().evolved().name())
                .with("visit", snapshot.visit().number())
                .with(
                        "function",
                        isNew && !snapshot.visit().over() && !snapshot.visit().startOwed());
        Transition by = snapshot.visit().by();
        if (isNew && by != null) {
            json.with("from", by.source().name()).with("by", by.event().toString());
        }
        json.with("sequence", state.sequence())
                .with("settled", state.open() == null && !snapshot.visit().over());
        Map<Event, Long> deadlines = snapshot.visit().deadlines();
        if (!deadlines.isEmpty()) {
            Map<String, Long> sorted = new TreeMap<>();
            deadlines.forEach((timer, due) -> sorted.put(timer.name(), millis(due)));
            json.withValues("timersMillis", sorted);
        }
        return snapshot.doubt() == null || snapshot.doubt().settled()
                ? json.bytes()
                : json.with("inDoubt", snapshot.doubt().why()).bytes();
    }

    /** For {@link Topic#DEAD_LETTERS}; a large record is cut, so that the letter can be sent. */
    public static byte[] deadLetter(
            Refusal refusal, String topic, int partition, long offset, byte @Nullable [] record) {
        byte[] whole = record == null ? new byte[0] : record;
        byte[] shown = whole.length > MOST_RECORD ? Arrays.copyOf(whole, MOST_RECORD) : whole;
        Json json = new Json()
                .with("reason", word(refusal.reason()))
                .with("detail", cut(refusal.detail(), MOST_DETAIL))
                .with("topic", topic)
                .with("partition", partition)
                .with("offset", offset)
                .with("record", Base64.getEncoder().encodeToString(shown));
        return (shown.length == whole.length ? json : json.with("bytes", whole.length)).bytes();
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

    /** How a constant is called in records. */
    @SuppressWarnings("EnumOrdinal") // of the array that was made of the same constants
    static String word(Enum<?> constant) {
        return WORDS.get(constant.getDeclaringClass())[constant.ordinal()];
    }

    /** The text of {@code record}, for logs and tables. */
    public static String text(byte[] record) {
        return new String(record, StandardCharsets.UTF_8);
    }
}
