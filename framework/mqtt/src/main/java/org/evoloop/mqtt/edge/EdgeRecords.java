package org.evoloop.mqtt.edge;

import org.evoloop.evolution.Occurrence;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The records in which a device tells a fleet what it has observed and done; a fleet's own programs write them, too.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class EdgeRecords {
    /** The version of the schemas. */
    public static final int SCHEMA = 1;

    private EdgeRecords() {}

    /**
     * What was observed.
     *
     * @param atMillis when, in milliseconds since 1970
     */
    public static JsonObject occurrence(Occurrence occurrence, long atMillis) {
        JsonObject record = new JsonObject().put("schema", SCHEMA).put("atMillis", atMillis);
        if (occurrence instanceof Occurrence.Found found) {
            return record.put("kind", "found").put("state", found.state().name());
        }
        record.put("kind", occurrence instanceof Occurrence.Asked ? "asked" : "heard")
                .put("event", occurrence.label());
        if (occurrence instanceof Occurrence.Heard heard) {
            record.put("source", JsonObject.word(heard.source())).put("deviceActed", heard.deviceActed());
            if (!heard.holding().isEmpty()) {
                record.putTexts("holding", heard.holding().stream().sorted().toList());
            }
        }
        if (occurrence.visit() != Occurrence.ANY_VISIT) {
            record.put("visit", occurrence.visit());
        }
        return record.putSome("values", occurrence.values().byName());
    }

    /**
     * What became of a command.
     *
     * @param sequence the number of the command
     * @param outcome the constant whose name is the outcome
     * @param reason why it failed, else empty
     * @param state where the device was found, if that was asked
     * @param atMillis when, in milliseconds since 1970
     */
    public static JsonObject effect(
            long sequence, Enum<?> outcome, String reason, @Nullable State state, long atMillis) {
        return new JsonObject()
                .put("schema", SCHEMA)
                .put("sequence", sequence)
                .put("outcome", JsonObject.word(outcome))
                .put("atMillis", atMillis)
                .putSome("reason", reason)
                .putSome("state", state == null ? "" : state.name());
    }
}
