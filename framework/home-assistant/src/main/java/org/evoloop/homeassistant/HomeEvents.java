package org.evoloop.homeassistant;

import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;

/**
 * Events of Home Assistant: those of a type on its bus, or those of a trigger as automations have it.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class HomeEvents {
    private final String request;
    private final String part;

    private HomeEvents(JsonObject request, String part) {
        this.request = request.toString();
        this.part = part;
    }

    /** Events of a type, such as {@code zha_event}; each reports its data, in JSON. */
    public static HomeEvents ofType(String type) {
        return new HomeEvents(HomeConnection.subscribing(type), "data");
    }

    /**
     * A trigger; each time, it reports its variables, in JSON.
     *
     * @param trigger in JSON, such as {@code {"trigger": "device", ...}}, or {@code {"platform": ...}} for an older Home
     *     Assistant
     * @throws IllegalArgumentException if it is no JSON object
     */
    public static HomeEvents trigger(String trigger) {
        return new HomeEvents(
                new JsonObject()
                        .put("type", "subscribe_trigger")
                        .put("trigger", JsonRecord.of(trigger).copy()),
                "variables");
    }

    JsonObject request() {
        return JsonRecord.of(request).copy();
    }

    /** Which part of an event is reported. */
    String part() {
        return part;
    }

    /** For messages. */
    @Override
    public String toString() {
        return request;
    }
}
