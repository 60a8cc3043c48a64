package org.evoloop.mqtt.home;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.function.Reading;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Entities of models whose names are in any language. */
class HomeDiscoveryTest {
    private static final List<String> EVENTS =
            List.of("switch", "goLeft", "speed+", "speed-", "電源", "速度", "Größe", "Grüße");

    private final HomeDiscovery discovery = new HomeDiscovery(new HomeTopics("lamp", "homeassistant"), "lamp");

    private JsonNode components() {
        return JsonMapper.shared().readTree(discovery.payload(null)).get("components");
    }

    @Test
    void everyEventHasItsOwnButton() {
        discovery.converter(PaperModels.lightBulb(), EVENTS, false);
        Set<String> pressed = new HashSet<>();
        Set<String> ids = new HashSet<>();
        components().properties().forEach(entity -> {
            JsonNode component = entity.getValue();
            ids.add(component.get("unique_id").asString());
            if (component.get("platform").asString().equals("button")) {
                pressed.add(component.get("payload_press").asString());
            }
            assertThat(component.get("default_entity_id").asString()).matches("[a-z_]+\\.[a-z0-9]+(_[a-z0-9]+)*");
        });
        assertThat(pressed).containsExactlyInAnyOrderElementsOf(EVENTS);
        assertThat(ids).hasSize(components().size());
        assertThat(components().propertyNames()).contains("press_switch", "press_go_left");
    }

    @Test
    void everyReadingHasItsOwnNameAndValue() {
        for (String name : List.of("timeLeft", "Füllstand", "温度", "湿度", "it's {50} %")) {
            discovery.reading(HomeReading.of(Reading.of(name, 1, "")));
        }
        assertThat(components().valueStream().map(each -> each.get("name").asString()))
                .containsExactlyInAnyOrder("Time left", "Füllstand", "温度", "湿度", "It's {50} %");
        assertThat(components()
                        .valueStream()
                        .map(each -> each.get("value_template").asString()))
                .contains(
                        "{{ value_json.readings.get('timeLeft') }}", "{{ value_json.readings.get('it\\'s {50} %') }}");
    }
}
