package org.evoloop.mqtt.home;

import java.util.List;
import java.util.Locale;
import org.evoloop.console.ShadowJson;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Shadow;
import org.evoloop.function.Reading;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.payload.JsonObject;

/** A converter's status as it is published: JSON, with the keys that {@link HomeDiscovery} names in its templates. */
final class HomeState {
    /** Home Assistant accepts states of up to 255 characters. */
    private static final int LONGEST = 250;

    /** Stands for an empty value where Home Assistant requires a text. */
    private static final String NONE = "none";

    /** Only the newest: Home Assistant keeps attributes of at most 16 KB. */
    private static final int DIFFERENCES = 10;

    /** No shadow: Home Assistant shows the value as unknown. */
    static final JsonObject NO_SHADOW = new JsonObject().put("different", (String) null);

    private HomeState() {}

    /** The state of converter and device. */
    static JsonObject state(ConverterStatus status, List<Choice> choices, JsonObject settings, String lastFailure) {
        JsonObject chosen = new JsonObject();
        choices.forEach(choice -> chosen.put(choice.key(), choice.current().get()));
        ConverterStatus.LinkStatus link = status.link();
        return new JsonObject()
                .put("converting", status.loop() == LoopState.RUNNING ? "ON" : "OFF")
                .put("device_state", status.states().original().name())
                .put("state", status.states().evolved().name())
                .put("system", status.system())
                .put("progress", text(status.function().describe()))
                .put("function", JsonObject.of(status.function().readings()))
                .put("reachable", link == null || link.up() ? "ON" : "OFF")
                .put("problem", text(problem(status)))
                .put("last_failure", text(lastFailure))
                .put("timers", timers(status.timers()))
                .put(
                        "next_timer",
                        status.timers().isEmpty() ? null : due(status.timers().get(0)))
                .put("readings", JsonObject.of(shown(readings(status))))
                .put("choices", chosen)
                .put("settings", settings);
    }

    /** The readings of the device; none while it cannot be reached. */
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

    /** When the timers are due. It stays the same while they run, so that no second brings a message of its own. */
    private static JsonObject timers(List<ConverterStatus.RunningTimer> running) {
        JsonObject timers = new JsonObject();
        running.forEach(timer -> timers.put(timer.event(), due(timer)));
        return timers;
    }

    private static String due(ConverterStatus.RunningTimer timer) {
        return timer.due().toString();
    }

    private static List<Reading> shown(List<Reading> readings) {
        return readings.stream()
                .map(reading ->
                        reading.value() instanceof String text ? Reading.of(reading.name(), cut(text)) : reading)
                .toList();
    }

    private static String text(String text) {
        return text.isEmpty() ? NONE : cut(text);
    }

    private static String cut(String text) {
        return text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text;
    }

    /** The converter's diagnostics. */
    static JsonObject diagnostics(ConverterStatus status, BrokerConnection connection) {
        return new JsonObject()
                .put("handled", status.events().handled())
                .put("ignored", status.events().ignored())
                .put("stale", status.events().stale())
                .put("failed", status.events().failed())
                .put("observed", status.events().observed())
                .put("drift", status.drift().unexplained())
                .put("drift_text", cut(status.drift().toString()))
                .put("waiting", status.events().waiting())
                .put("in_progress", status.events().inProgress())
                .put("dropped", status.queue().dropped())
                .put("refused", status.queue().refused())
                .put("conversion_millis", millis(status.conversionTime().medianNanos()))
                .put("connects", connection.connects())
                .put("lost", connection.lost());
    }

    /** In the unit that every version of Home Assistant knows, to a microsecond. */
    private static double millis(long nanos) {
        return Math.round(nanos / 1e3) / 1e3;
    }

    /** The report of the shadow; none after it has ended. */
    static JsonObject shadow(Shadow shadow) {
        try {
            return ShadowJson.of(shadow.report(), DIFFERENCES);
        } catch (IllegalStateException ended) {
            return NO_SHADOW;
        }
    }

    /** The outcome of an event, and the reason. */
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
                .put("at", entry.at().toString())
                .put("observed_at", entry.observedAt().toString());
    }

    /** A refused command. */
    static JsonObject refusal(String command, String why) {
        return new JsonObject()
                .put("event_type", HomeDiscovery.REFUSED)
                .put("event", command)
                .put("source", "home assistant")
                .put("why", why);
    }

    /** That something has failed. */
    static JsonObject failure(String type, String what) {
        return new JsonObject().put("event_type", type).put("text", what);
    }
}
