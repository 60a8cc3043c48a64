package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
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
            "name",
            "entity_category",
            "device_class",
            "state_topic",
            "value_template",
            "enabled_by_default");
    private static final Map<String, Set<String>> MORE = Map.of(
            "sensor",
                    Set.of(
                            "options",
                            "state_class",
                            "unit_of_measurement",
                            "json_attributes_topic",
                            "json_attributes_template"),
            "binary_sensor", Set.of(),
            "button", Set.of("command_topic", "payload_press"),
            "switch", Set.of("command_topic"),
            "select", Set.of("command_topic", "options"),
            "event", Set.of("event_types"),
            "vacuum", Set.of("command_topic", "supported_features"));
    private static final Map<String, Set<String>> NEEDED = Map.of(
            "sensor", Set.of("state_topic"),
            "binary_sensor", Set.of("state_topic"),
            "button", Set.of("command_topic"),
            "switch", Set.of("command_topic"),
            "select", Set.of("command_topic", "options"),
            "event", Set.of("state_topic", "event_types"),
            "vacuum", Set.of("command_topic"));
    private static final Pattern MEMBER = Pattern.compile("value_json\\.([a-z_]+)");

    private DiscoverySchema() {}

    /**
     * Checks a payload.
     *
     * @param published the newest messages on the topics that templates read
     */
    static void check(String payload, Map<String, String> published) {
        JsonNode config = JsonMapper.shared().readTree(payload);
        assertThat(config.propertyNames())
                .containsExactlyInAnyOrder("device", "origin", "availability_topic", "qos", "components");
        assertThat(config.at("/device/identifiers/0").asString()).isNotEmpty();
        assertThat(config.at("/origin/name").asString()).isNotEmpty();
        assertThat(config.at("/device/sw_version").asString()).matches("[0-9]+\\.[0-9]+.*");
        Set<String> ids = new HashSet<>();
        config.get("components").properties().forEach(entity -> {
            JsonNode component = entity.getValue();
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
        assertThat(config.get("components").propertyNames())
                .contains(
                        "vacuum",
                        "model",
                        "press_switch",
                        "decision",
                        "reading_battery",
                        "reading_charging",
                        "reading_mood");
        assertThat(config.get("components").propertyNames()).doesNotContain("press_timeout");
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
