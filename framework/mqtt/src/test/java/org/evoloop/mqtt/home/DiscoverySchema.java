package org.evoloop.mqtt.home;

import static java.util.Map.entry;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * What Home Assistant 2026.11 requires of a device's discovery payload (its integration "mqtt": {@code schemas.py} and
 * the platforms' own), as far as it applies to what is published here. The real one is tested by {@code ./evoloop test
 * --home-assistant}.
 */
final class DiscoverySchema {
    private static final Set<String> COMMON = Set.of(
            "platform",
            "unique_id",
            "default_entity_id",
            "icon",
            "name",
            "entity_category",
            "device_class",
            "state_topic",
            "value_template",
            "enabled_by_default");
    private static final Set<String> COMMANDS =
            Set.of("command_topic", "payload_on", "payload_off", "state_value_template");
    private static final Set<String> MOVES = Set.of("command_topic", "payload_open", "payload_close", "payload_stop");

    /** The keys of each kind's page that are used, such as those of "MQTT Cover". */
    private static final Map<String, Set<String>> MORE = Map.ofEntries(
            entry(
                    "sensor",
                    Set.of(
                            "options",
                            "state_class",
                            "unit_of_measurement",
                            "json_attributes_topic",
                            "json_attributes_template")),
            entry("binary_sensor", Set.of()),
            entry("button", Set.of("command_topic", "payload_press")),
            entry("switch", Set.of("command_topic", "payload_on", "payload_off", "state_on", "state_off")),
            entry("select", Set.of("command_topic", "options")),
            entry("time", Set.of("command_topic")),
            entry("text", Set.of("command_topic")),
            entry("image", Set.of("image_topic", "content_type")),
            entry("event", Set.of("event_types")),
            entry("vacuum", Set.of("command_topic", "supported_features")),
            entry("cover", with(MOVES, "position_topic", "position_template")),
            entry("valve", with(MOVES, "reports_position")),
            entry(
                    "light",
                    with(
                            COMMANDS,
                            "on_command_type",
                            "effect_list",
                            "effect_state_topic",
                            "effect_command_topic",
                            "effect_value_template")),
            entry(
                    "fan",
                    with(
                            COMMANDS,
                            "preset_modes",
                            "preset_mode_state_topic",
                            "preset_mode_command_topic",
                            "preset_mode_value_template")),
            entry(
                    "humidifier",
                    with(
                            COMMANDS,
                            "target_humidity_command_topic",
                            "modes",
                            "mode_state_topic",
                            "mode_command_topic",
                            "mode_state_template")),
            entry(
                    "climate",
                    Set.of(
                            "modes",
                            "mode_state_topic",
                            "mode_state_template",
                            "mode_command_topic",
                            "power_command_topic",
                            "payload_on",
                            "payload_off",
                            "current_temperature_topic",
                            "current_temperature_template",
                            "preset_modes",
                            "preset_mode_state_topic",
                            "preset_mode_command_topic",
                            "preset_mode_value_template")),
            entry(
                    "lock",
                    Set.of(
                            "command_topic",
                            "payload_lock",
                            "payload_unlock",
                            "payload_open",
                            "state_locked",
                            "state_unlocked",
                            "state_locking",
                            "state_unlocking",
                            "state_open",
                            "state_opening",
                            "state_jammed")));

    private static final Map<String, Set<String>> NEEDED = Map.ofEntries(
            entry("sensor", Set.of("state_topic")),
            entry("binary_sensor", Set.of("state_topic")),
            entry("button", Set.of("command_topic")),
            entry("switch", Set.of("command_topic")),
            entry("select", Set.of("command_topic", "options")),
            entry("time", Set.of("command_topic")),
            entry("text", Set.of("command_topic")),
            entry("image", Set.of("image_topic")),
            entry("event", Set.of("state_topic", "event_types")),
            entry("vacuum", Set.of("command_topic")),
            entry("cover", Set.of("command_topic", "state_topic")),
            entry("valve", Set.of("command_topic", "state_topic")),
            entry("light", Set.of("command_topic")),
            entry("fan", Set.of("command_topic")),
            entry("humidifier", Set.of("command_topic", "target_humidity_command_topic")),
            entry("climate", Set.of("modes", "mode_command_topic", "mode_state_topic")),
            entry("lock", Set.of("command_topic")));
    private static final Pattern MEMBER = Pattern.compile("value_json\\.([a-z_]+)");

    private DiscoverySchema() {}

    private static Set<String> with(Set<String> some, String... more) {
        Set<String> all = new HashSet<>(some);
        all.addAll(List.of(more));
        return all;
    }

    /**
     * Checks a payload.
     *
     * @param published the newest messages on the topics that templates read
     * @param expected entities that must be there
     */
    static void check(String payload, Map<String, String> published, Set<String> expected) {
        JsonNode config = JsonMapper.shared().readTree(payload);
        assertThat(config.propertyNames())
                .containsExactlyInAnyOrder("device", "origin", "availability_topic", "qos", "components");
        assertThat(config.at("/device/identifiers/0").asString()).isNotEmpty();
        assertThat(config.at("/origin/name").asString()).isNotEmpty();
        assertThat(config.at("/device/sw_version").asString()).matches("[0-9]+\\.[0-9]+.*");
        Set<String> ids = new HashSet<>();
        config.get("components").properties().forEach(entity -> {
            JsonNode component = entity.getValue();
            checkModes(component);
            String platform = component.get("platform").asString();
            assertThat(MORE).containsKey(platform);
            Set<String> allowed = new HashSet<>(COMMON);
            allowed.addAll(MORE.get(platform));
            assertThat(allowed).as(entity.getKey()).containsAll(component.propertyNames());
            assertThat(component.propertyNames()).as(entity.getKey()).containsAll(NEEDED.get(platform));
            assertThat(ids.add(component.get("unique_id").asString()))
                    .as("unique_id of " + entity.getKey())
                    .isTrue();
            assertThat(component.get("default_entity_id").asString()).matches(platform + "\\.[a-z0-9_]+");
            checkClass(entity.getKey(), component);
            boolean isCounter = component.at("/state_topic").asString("").endsWith("/diagnostics");
            assertThat(component.path("enabled_by_default").asBoolean(true))
                    .as(entity.getKey())
                    .isEqualTo(!isCounter);
            checkTemplate(entity.getKey(), component, published);
        });
        assertThat(config.get("components").propertyNames()).containsAll(expected);
        assertThat(config.get("components").propertyNames()).doesNotContain("press_timeout");
    }

    /** What Home Assistant refuses: an empty list, and a preset with the name that it has for no preset. */
    private static void checkModes(JsonNode component) {
        for (String list : List.of("modes", "preset_modes", "effect_list", "options", "event_types")) {
            if (component.has(list)) {
                assertThat(component.get(list)).as(list).isNotEmpty();
                assertThat(component.get(list))
                        .as(list)
                        .noneMatch(each -> each.asString().equals("none"));
            }
        }
        if (component.get("platform").asString().equals("climate")) {
            assertThat(component.get("modes"))
                    .allMatch(each -> Set.of("auto", "off", "cool", "heat", "heat_cool", "dry", "fan_only")
                            .contains(each.asString()));
        }
    }

    private static void checkClass(String key, JsonNode component) {
        String known = component.path("device_class").asString("");
        if (component.has("options") && component.get("platform").asString().equals("sensor")) {
            assertThat(known).as(key).isEqualTo("enum");
            assertThat(component.has("state_class")).as(key).isFalse();
        }
        if (known.equals("duration")) {
            // Those with a micro sign exist twice in Unicode, and were changed from one to the other.
            assertThat(component.get("unit_of_measurement").asString()).isIn("ms", "s", "min", "h", "d");
        }
        if (known.equals("timestamp")) {
            assertThat(component.has("state_class")).as(key).isFalse();
        }
        if (known.equals("battery")) {
            assertThat(component.get("unit_of_measurement").asString()).isEqualTo("%");
        }
        if (component.get("platform").asString().equals("binary_sensor")) {
            assertThat(component.has("unit_of_measurement")).as(key).isFalse();
        }
    }

    private static void checkTemplate(String key, JsonNode component, Map<String, String> published) {
        Matcher members = MEMBER.matcher(component.path("value_template").asString(""));
        while (members.find()) {
            String topic = component.get("state_topic").asString();
            assertThat(published).as(key).containsKey(topic);
            assertThat(JsonMapper.shared().readTree(published.get(topic)).propertyNames())
                    .as(key)
                    .contains(members.group(1));
        }
    }
}
