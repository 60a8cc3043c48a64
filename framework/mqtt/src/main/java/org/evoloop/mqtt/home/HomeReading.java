package org.evoloop.mqtt.home;

import java.util.Locale;
import java.util.Map;
import org.evoloop.function.Reading;
import org.evoloop.payload.JsonObject;

/**
 * A reading as an entity: a binary sensor for a boolean, else a sensor.
 *
 * @param name the reading's
 * @param kind the kind of its value
 * @param unit the unit of a number; else empty
 */
record HomeReading(String name, Kind kind, String unit) {
    private static final Map<String, String> CLASSES_BY_UNIT = Map.of(
            "V",
            "voltage",
            "mV",
            "voltage",
            "A",
            "current",
            "mA",
            "current",
            "°C",
            "temperature",
            "W",
            "power",
            "mm",
            "distance",
            "m",
            "distance",
            "s",
            "duration",
            "min",
            "duration");

    /** The kind of a value. */
    enum Kind {
        YES_OR_NO,
        NUMBER,
        TEXT
    }

    static HomeReading of(Reading reading) {
        Kind kind = reading.value() instanceof Boolean
                ? Kind.YES_OR_NO
                : reading.value() instanceof String ? Kind.TEXT : Kind.NUMBER;
        return new HomeReading(reading.name(), kind, reading.unit());
    }

    String platform() {
        return kind == Kind.YES_OR_NO ? "binary_sensor" : "sensor";
    }

    /** For people: {@code Time left}. */
    String title() {
        String words = name.replaceAll("(?<=[a-z0-9])(?=[A-Z])", " ")
                .replaceAll("[\\s_]+", " ")
                .toLowerCase(Locale.ROOT)
                .strip();
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    /** The template that extracts it from the state; a missing one is unknown. */
    String template() {
        String value = "value_json.readings.get('" + name.replaceAll("(['\\\\])", "\\\\$1") + "')";
        return kind == Kind.YES_OR_NO
                ? "{{ None if " + value + " is none else 'ON' if " + value + " else 'OFF' }}"
                : "{{ " + value + " }}";
    }

    void describe(JsonObject sensor) {
        if (kind == Kind.NUMBER) {
            sensor.put("state_class", "measurement");
            if (!unit.isEmpty()) {
                sensor.put("unit_of_measurement", unit);
            }
            String known = name.equals("battery") && unit.equals("%") ? "battery" : CLASSES_BY_UNIT.get(unit);
            if (known != null) {
                sensor.put("device_class", known);
            }
        } else if (kind == Kind.YES_OR_NO && name.equals("charging")) {
            sensor.put("device_class", "battery_charging");
        }
    }
}
