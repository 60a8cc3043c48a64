package org.evoloop.mqtt.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.payload.JsonObject;

/** An entity's part of the discovery message, in the words of its kind's page ("MQTT Cover" and so on). */
final class HomeNative {
    private static final String STATE = "{{ value_json.state }}";
    private static final String MODE = "{{ value_json.mode }}";

    private final HomeTopics topics;
    private final HomeEntity entity;
    private final HomeTable table;
    private final String key;

    HomeNative(HomeTopics topics, HomeEntity entity, HomeTable table) {
        this.topics = topics;
        this.entity = entity;
        this.table = table;
        this.key = entity.key();
    }

    JsonObject describe(JsonObject to) {
        if (!entity.deviceClass().isEmpty()) {
            to.put("device_class", entity.deviceClass());
        }
        return switch (entity.kind()) {
            case COVER -> cover(moves(to));
            case VALVE -> moves(to).put("value_template", STATE).put("reports_position", false);
            case CLIMATE -> climate(to);
            case LIGHT -> light(onOff(to, "state_value_template"));
            case SWITCH -> onOff(to, "value_template").put("state_on", "on").put("state_off", "off");
            case FAN ->
                modes(onOff(to, "state_value_template"), "preset_modes", "preset_mode", "preset_mode_value_template");
            case HUMIDIFIER ->
                modes(
                        onOff(to, "state_value_template").put("target_humidity_command_topic", topics.humidity(key)),
                        "modes",
                        "mode",
                        "mode_state_template");
            case LOCK -> lock(to);
            case VACUUM -> state(to).putTexts("supported_features", features());
            case SELECT ->
                to.put("state_topic", topics.entity(key))
                        .put("value_template", MODE)
                        .put("command_topic", topics.mode(key))
                        .putTexts("options", table.modes());
            case BUTTON -> to.put("command_topic", topics.command(key)).put("payload_press", "press");
            case EVENT -> to.put("state_topic", topics.entity(key)).putTexts("event_types", table.modes());
        };
    }

    private JsonObject state(JsonObject to) {
        return to.put("state_topic", topics.entity(key)).put("command_topic", topics.command(key));
    }

    private JsonObject onOff(JsonObject to, String template) {
        return state(to).put("payload_on", "on").put("payload_off", "off").put(template, STATE);
    }

    /** Home Assistant has no state for a cover that rests in between, or moves nobody knows where: it is open. */
    private JsonObject moves(JsonObject to) {
        for (String command : List.of("open", "close", "stop")) {
            to.put("payload_" + command, table.commands().contains(command) ? command : null);
        }
        return state(to);
    }

    private JsonObject cover(JsonObject to) {
        if (!entity.reading().isEmpty()) {
            to.put("position_topic", topics.entity(key))
                    .put("position_template", "{{ value_json.get('position', '') }}");
        }
        return to.put("value_template", STATE);
    }

    private JsonObject climate(JsonObject to) {
        Set<String> hvac = HomeKind.CLIMATE.shown();
        List<String> offered = new ArrayList<>(table.shownStates());
        offered.retainAll(hvac);
        to.putTexts("modes", offered)
                .put("mode_state_topic", topics.entity(key))
                .put("mode_state_template", STATE)
                .put("mode_command_topic", topics.command(key));
        if (table.commands().containsAll(List.of("turn_on", "turn_off"))) {
            to.put("power_command_topic", topics.command(key))
                    .put("payload_on", "turn_on")
                    .put("payload_off", "turn_off");
        }
        if (!entity.reading().isEmpty()) {
            to.put("current_temperature_topic", topics.entity(key))
                    .put("current_temperature_template", "{{ value_json.get('temperature', 'None') }}");
        }
        return modes(to, "preset_modes", "preset_mode", "preset_mode_value_template");
    }

    /** With an effect, it is switched on first. */
    private JsonObject light(JsonObject to) {
        if (!table.modes().isEmpty()) {
            to.put("on_command_type", "first");
            modes(to, "effect_list", "effect", "effect_value_template");
            to.put("effect_value_template", "{{ value_json.mode or 'off' }}");
        }
        return to;
    }

    private JsonObject modes(JsonObject to, String list, String mode, String template) {
        if (table.modes().isEmpty()) {
            return to;
        }
        return to.putTexts(list, table.modes())
                .put(mode + "_state_topic", topics.entity(key))
                .put(mode + "_command_topic", topics.mode(key))
                .put(template, MODE);
    }

    private JsonObject lock(JsonObject to) {
        for (String state : List.of("locked", "unlocked", "locking", "unlocking", "open", "opening", "jammed")) {
            to.put("state_" + state, state);
        }
        to.put("payload_lock", "lock").put("payload_unlock", "unlock");
        if (table.commands().contains("open")) {
            to.put("payload_open", "open");
        }
        return state(to).put("value_template", STATE);
    }

    private List<String> features() {
        List<String> features = new ArrayList<>(table.commands());
        features.addAll(entity.hooks().commands());
        features.replaceAll(command -> command.equals("return_to_base") ? "return_home" : command);
        features.add("status");
        return features;
    }

    /** What is published of it. */
    static JsonObject published(HomeEntity entity, HomeTable table, ConverterStatus status) {
        String shown = HomeOperator.shown(entity, table, status);
        String mode = table.mode(status.states().evolved());
        boolean between = shown.equals("stopped") || shown.equals("moving");
        JsonObject published = new JsonObject().put("state", shown.isEmpty() ? null : between ? "open" : shown);
        if (!table.modes().isEmpty()) {
            published.put("mode", mode.isEmpty() ? null : mode);
        }
        HomeState.readings(status).stream()
                .filter(reading -> reading.name().equals(entity.reading()) && reading.value() instanceof Number)
                .forEach(reading -> published.put(
                        entity.kind() == HomeKind.COVER ? "position" : "temperature",
                        ((Number) reading.value()).doubleValue()));
        return published;
    }

    /** The command in a message: Home Assistant gives some kinds the state as the command. */
    static String command(HomeEntity entity, String payload) {
        return entity.kind().isOnOrOff() ? "turn_" + payload : payload;
    }
}
