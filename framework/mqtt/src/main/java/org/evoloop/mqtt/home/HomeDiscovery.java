package org.evoloop.mqtt.home;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Properties;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Outcome;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The discovery message of a converter: one device with its entities (Home Assistant, "MQTT", device discovery payload;
 * as of 2026.11).
 *
 * <p>Threading: not thread-safe.
 */
final class HomeDiscovery {
    /** The event type for a refused command. */
    static final String REFUSED = "refused";

    /** The event type for an event that has failed, or a property that is violated. */
    static final String FAILED = "failed";

    /** The event type for a device that cannot be reached any more. */
    static final String UNREACHABLE = "unreachable";

    private static final String DIAGNOSTIC = "diagnostic";
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9]+(?:[ _.-][A-Za-z0-9]+)*");

    private static final String VERSION = version();

    private final HomeTopics topics;
    private final String name;
    private final JsonObject components = new JsonObject();

    /** @param converter its name */
    HomeDiscovery(HomeTopics topics, String converter) {
        this.topics = topics;
        this.name = converter.substring(0, 1).toUpperCase(Locale.ROOT) + converter.substring(1);
    }

    private static String version() {
        try (InputStream file = Objects.requireNonNull(HomeDiscovery.class.getResourceAsStream("evoloop.properties"))) {
            Properties properties = new Properties();
            properties.load(file);
            return properties.getProperty("version");
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    /**
     * A name converted for topics, entity names and templates: lower-case ASCII letters and digits, separated by {@code
     * _}. Names that differ only in other characters, such as {@code speed+} and {@code speed-}, or that consist of
     * them, still get different keys.
     */
    static String key(String text) {
        String plain = text.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_")
                .toLowerCase(Locale.ROOT)
                .replaceAll("[^a-z0-9]+", "_")
                .replaceAll("^_|_$", "");
        return PLAIN.matcher(text).matches()
                ? plain
                : (plain.isEmpty() ? "" : plain + "_") + "x" + Integer.toHexString(text.hashCode());
    }

    /**
     * The entities of every converter.
     *
     * @param beside whether they are beside an entity that shows the state
     */
    HomeDiscovery converter(ModelPair models, Collection<String> buttons, boolean beside) {
        UnaryOperator<JsonObject> category = beside ? each -> each.put("entity_category", DIAGNOSTIC) : each -> each;
        states("device_state", "Device state", models.original().states(), category);
        states("state", "State", models.evolved().states(), category);
        add("event", "decision", "Decision", event -> {
            List<String> types = new ArrayList<>();
            for (Outcome outcome : Outcome.values()) {
                types.add(outcome.name().toLowerCase(Locale.ROOT));
            }
            types.add(REFUSED);
            return category.apply(event.put("state_topic", topics.decision()).putTexts("event_types", types));
        });
        add(
                "event",
                "failure",
                "Failure",
                event -> event.put("state_topic", topics.failure())
                        .putTexts("event_types", List.of(FAILED, REFUSED, UNREACHABLE))
                        .put("entity_category", DIAGNOSTIC));
        for (String button : buttons) {
            add(
                    "button",
                    "press_" + key(button),
                    "Press " + button,
                    press -> press.put("command_topic", topics.press()).put("payload_press", button));
        }
        add(
                "switch",
                "converting",
                "Converting",
                onOff -> onOff.put("state_topic", topics.state())
                        .put("value_template", "{{ value_json.converting }}")
                        .put("command_topic", topics.converting())
                        .put("entity_category", "config"));
        add(
                "sensor",
                "progress",
                "Progress",
                progress -> category.apply(progress.put("state_topic", topics.state())
                        .put("value_template", "{{ value_json.progress }}")
                        .put("json_attributes_topic", topics.state())
                        .put("json_attributes_template", "{{ value_json.function | tojson }}")));
        add(
                "sensor",
                "next_timer",
                "Next timer",
                timer -> category.apply(timer.put("device_class", "timestamp")
                        .put("state_topic", topics.state())
                        .put("value_template", "{{ value_json.next_timer }}")
                        .put("json_attributes_topic", topics.state())
                        .put("json_attributes_template", "{{ value_json.timers | tojson }}")));
        ofState("sensor", "problem", "Problem");
        ofState("sensor", "last_failure", "Last failure");
        for (String each : List.of("handled", "ignored", "stale", "failed", "dropped", "refused")) {
            diagnostic(each, "Events " + each, count -> count.put("state_class", "total_increasing"));
        }
        diagnostic(
                "drift",
                "Acts that are not in the model",
                drift -> drift.put("state_class", "measurement")
                        .put("json_attributes_topic", topics.diagnostics())
                        .put("json_attributes_template", "{{ {'edges': value_json.drift_text} | tojson }}"));
        diagnostic("waiting", "Events waiting", depth -> depth.put("state_class", "measurement"));
        diagnostic(
                "conversion_millis",
                "Conversion time",
                time -> time.put("state_class", "measurement")
                        .put("device_class", "duration")
                        .put("unit_of_measurement", "ms"));
        return this;
    }

    /** Whether the device can be reached. */
    HomeDiscovery link() {
        return add(
                "binary_sensor",
                "reachable",
                "Reachable",
                reachable -> reachable
                        .put("device_class", "connectivity")
                        .put("state_topic", topics.state())
                        .put("value_template", "{{ value_json.reachable }}")
                        .put("entity_category", DIAGNOSTIC));
    }

    /** An entity, after which the device is named if it has no name of its own. */
    HomeDiscovery entity(HomeEntity entity, HomeTable table) {
        return add(
                entity.kind().word(),
                entity.key(),
                entity.name().isEmpty() ? null : entity.name(),
                to -> new HomeNative(topics, entity, table).describe(to));
    }

    /** The differences of a shadow, and the button that promotes it. */
    HomeDiscovery shadow() {
        add(
                "sensor",
                "shadow_different",
                "Shadow decided differently",
                count -> count.put("state_topic", topics.shadow())
                        .put("value_template", "{{ value_json.different }}")
                        .put("json_attributes_topic", topics.shadow())
                        .put("state_class", "total_increasing")
                        .put("entity_category", DIAGNOSTIC));
        return add(
                "button",
                "promote",
                "Promote shadow",
                promote -> promote.put("command_topic", topics.promote())
                        .put("payload_press", "PROMOTE")
                        .put("entity_category", "config"));
    }

    /** A choice. */
    HomeDiscovery choice(Choice choice) {
        return add(
                "select",
                choice.key(),
                choice.name(),
                select -> select.put("state_topic", topics.state())
                        .put("value_template", "{{ value_json.choices." + choice.key() + " }}")
                        .put("command_topic", topics.choice(choice.key()))
                        .putTexts("options", choice.options())
                        .put("entity_category", "config"));
    }

    /** A setting; one that is only shown is a time. */
    HomeDiscovery setting(HomeSetting setting) {
        return add(setting.platform(), setting.key(), setting.name(), to -> {
            to.put("state_topic", topics.state())
                    .put("value_template", "{{ value_json.settings." + setting.key() + " }}")
                    .putSome("icon", setting.icon());
            if (!setting.isSet()) {
                return to.put("device_class", "timestamp");
            }
            to.put("command_topic", topics.setting(setting.key()));
            // Switches are what an owner uses every day.
            return setting.platform().equals("switch") ? to : to.put("entity_category", "config");
        });
    }

    /** The picture of a model. */
    HomeDiscovery picture(String key, String title) {
        return add(
                "image",
                key,
                title,
                image -> image.put("image_topic", topics.picture(key))
                        .put("content_type", "image/svg+xml")
                        .put("entity_category", DIAGNOSTIC));
    }

    /** A reading of the device. */
    HomeDiscovery reading(HomeReading reading) {
        return add(reading.platform(), "reading_" + key(reading.name()), reading.title(), sensor -> {
            sensor.put("state_topic", topics.state()).put("value_template", reading.template());
            reading.describe(sensor);
            return sensor;
        });
    }

    private void states(String key, String entity, Collection<State> states, UnaryOperator<JsonObject> category) {
        add(
                "sensor",
                key,
                entity,
                sensor -> category.apply(sensor.put("device_class", "enum")
                        .putTexts("options", states.stream().map(State::name).toList())
                        .put("state_topic", topics.state())
                        .put("value_template", "{{ value_json." + key + " }}")));
    }

    private void ofState(String platform, String key, String entity) {
        add(
                platform,
                key,
                entity,
                sensor -> sensor.put("state_topic", topics.state())
                        .put("value_template", "{{ value_json." + key + " }}")
                        .put("entity_category", DIAGNOSTIC));
    }

    /** Shown by those who want it: it changes with every event, and Home Assistant would record each value. */
    private void diagnostic(String key, String entity, UnaryOperator<JsonObject> more) {
        add(
                "sensor",
                key,
                entity,
                sensor -> more.apply(sensor.put("state_topic", topics.diagnostics())
                        .put("value_template", "{{ value_json." + key + " }}")
                        .put("entity_category", DIAGNOSTIC)
                        .put("enabled_by_default", false)));
    }

    private HomeDiscovery add(String platform, String key, @Nullable String entity, UnaryOperator<JsonObject> more) {
        components.put(
                key,
                more.apply(new JsonObject()
                        .put("platform", platform)
                        .put("unique_id", "evoloop_" + topics.id() + "_" + key)
                        .put("default_entity_id", platform + "." + entityId(key, entity))
                        .put("name", entity)));
        return this;
    }

    private String entityId(String key, @Nullable String entity) {
        return entity == null ? key(topics.id()) : key(topics.id()) + "_" + key;
    }

    /**
     * The payload with everything added.
     *
     * @param page the address of the converter's page; null if it has none
     */
    String payload(@Nullable URI page) {
        JsonObject device = new JsonObject()
                .putTexts("identifiers", List.of("evoloop_" + topics.id()))
                .put("name", name)
                .put("manufacturer", "Evoloop")
                .put("model", "Event converter")
                .put("sw_version", VERSION);
        if (page != null) {
            device.put("configuration_url", page.toString());
        }
        return new JsonObject()
                .put("device", device)
                .put("origin", new JsonObject().put("name", "Evoloop").put("sw_version", VERSION))
                .put("availability_topic", topics.availability())
                .put("qos", 1)
                .put("components", components)
                .toString();
    }
}
