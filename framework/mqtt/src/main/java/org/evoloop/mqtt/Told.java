package org.evoloop.mqtt;

import java.util.concurrent.CompletableFuture;
import org.evoloop.converter.PushMonitor;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.payload.JsonObject;

/**
 * Tells by MQTT what became of a press.
 *
 * <p>Threading: any thread may call it.
 *
 * @since 0.1
 */
public final class Told {
    private Told() {}

    /**
     * Submits {@code event}, and publishes its outcome on {@code topic} when it is known.
     *
     * @return completes with the outcome, also where the converter does not take the event
     */
    public static CompletableFuture<EventOutcome> submit(
            PushMonitor controller, String event, Values values, BrokerConnection connection, String topic) {
        CompletableFuture<EventOutcome> submitted;
        try {
            submitted = controller.submit(event, values);
        } catch (IllegalArgumentException | IllegalStateException never) {
            submitted = CompletableFuture.completedFuture(new EventOutcome.Refused(String.valueOf(never.getMessage())));
        }
        return submitted.whenComplete((outcome, never) -> connection.publish(Message.event(
                topic,
                new JsonObject()
                        .put("event", event)
                        .put("outcome", outcome.kind())
                        .put("text", outcome.toString())
                        .toString())));
    }
}
