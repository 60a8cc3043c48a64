package org.evoloop.mqtt;

import java.util.List;
import java.util.Locale;
import org.evoloop.console.JsonObject;
import org.evoloop.console.ShadowJson;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Shadow;
import org.evoloop.function.Reading;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;

/** A converter's status as it is published: JSON, with the keys that {@link HomeDiscovery} names in its templates. */
final class HomeState {
    /** Home Assistant takes states of 255 characters. */
    private static final int LONGEST = 250;

    /** What stands for nothing where Home Assistant wants a text. */
    private static final String NONE = "none";

    /** The newest: Home Assistant keeps attributes of 16 KB. */
    private static final int DIFFERENCES = 10;

    /** No shadow: Home Assistant takes it for unknown. */
    static final JsonObject NO_SHADOW = new JsonObject().put("different", (String) null);

    private HomeState() {}

    /** How converter and device are. */
    static JsonObject state(ConverterStatus status, List<Choice> choices, String lastFailure) {
        JsonObject chosen = new JsonObject();
        choices.forEach(choice -> chosen.put(choice.key(), choice.current().get()));
        ConverterStatus.LinkStatus link = status.link();
        return new JsonObject()
                .put("converting", status.loop() == LoopState.RUNNING ? "ON" : "OFF")
                .put("device_state", status.states().original().name())
                .put("state", status.states().evolved().name())
                .put("progress", text(status.function().describe()))
                .put("function", JsonObject.of(status.function().readings()))
                .put("reachable", link == null || link.up() ? "ON" : "OFF")
                .put("problem", text(problem(status)))
                .put("last_failure", text(lastFailure))
                .put("readings", JsonObject.of(readings(status)))
                .put("choices", chosen);
    }

    /** What is known of the device; nothing while it is out of reach. */
    static List<Reading> readings(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        return link == null ? List.of() : link.readings();
    }

    private static String problem(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        if (link != null && !link.up()) {
            return link.text();
        }
        if (!status.doubt().isEmpty()) {
            return status.doubt();
        }
        for (ComponentStatus component : status.components()) {
            if (component.activity() == ComponentStatus.Activity.STUCK) {
                return component.name() + " is stuck";
            }
        }
        return "";
    }

    private static String text(String text) {
        return text.isEmpty() ? NONE : text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text;
    }

    /** How the converter fares. */
    static JsonObject diagnostics(ConverterStatus status, BrokerConnection connection) {
        return new JsonObject()
                .put("handled", status.events().handled())
                .put("ignored", status.events().ignored())
                .put("stale", status.events().stale())
                .put("failed", status.events().failed())
                .put("waiting", status.queue().depth())
                .put("dropped", status.queue().dropped())
                .put("refused", status.queue().refused())
                .put("conversion_micros", status.conversionTime().medianNanos() / 1000)
                .put("connects", connection.connects())
                .put("lost", connection.lost());
    }

    /** What other models would have decided; nothing once they have ended. */
    static JsonObject shadow(Shadow shadow) {
        try {
            return ShadowJson.of(shadow.report(), DIFFERENCES);
        } catch (IllegalStateException ended) {
            return NO_SHADOW;
        }
    }

    /** What became of an event, and why. */
    static JsonObject decision(HistoryEntry entry) {
        return new JsonObject()
                .put("event_type", entry.outcome().name().toLowerCase(Locale.ROOT))
                .put("event", entry.occurrence().label())
                .put("source", entry.occurrence().source().name().toLowerCase(Locale.ROOT))
                .put("why", entry.detail())
                .put("device_state_before", entry.before().original().name())
                .put("device_state", entry.after().original().name())
                .put("state_before", entry.before().evolved().name())
                .put("state", entry.after().evolved().name())
                .put("number", entry.number())
                .put("at", entry.at().toString());
    }

    /** That a command was not obeyed. */
    static JsonObject refusal(String command, String why) {
        return new JsonObject()
                .put("event_type", HomeDiscovery.REFUSED)
                .put("event", command)
                .put("source", "home assistant")
                .put("why", why);
    }
}
