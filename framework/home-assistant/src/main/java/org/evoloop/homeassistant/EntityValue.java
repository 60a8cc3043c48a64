package org.evoloop.homeassistant;

import static java.util.Map.entry;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.evoloop.payload.Part;
import org.jspecify.annotations.Nullable;

/**
 * A value in Home Assistant: the state of an entity, or one of its attributes.
 *
 * <p>Threading: immutable.
 *
 * @param entity its id, such as {@code light.kitchen}
 * @param attribute such as {@code brightness}; null for the state
 * @since 0.1
 */
public record EntityValue(String entity, @Nullable String attribute) {
    private static final Pattern ID = Pattern.compile("[a-z0-9_]+\\.[a-z0-9_]+");
    private static final Set<String> ON_OFF = Set.of("on", "off");
    private static final Map<String, Set<String>> STATES = Map.ofEntries(
            entry("light", ON_OFF),
            entry("switch", ON_OFF),
            entry("fan", ON_OFF),
            entry("humidifier", ON_OFF),
            entry("siren", ON_OFF),
            entry("binary_sensor", ON_OFF),
            entry("input_boolean", ON_OFF),
            entry("remote", ON_OFF),
            entry("cover", Set.of("open", "opening", "closed", "closing")),
            entry("valve", Set.of("open", "opening", "closed", "closing")),
            entry("lock", Set.of("locked", "unlocked", "locking", "unlocking", "open", "opening", "jammed")),
            entry("vacuum", Set.of("cleaning", "docked", "idle", "paused", "returning", "error")),
            entry("lawn_mower", Set.of("mowing", "docked", "idle", "paused", "returning", "error")),
            entry("climate", Set.of("off", "heat", "cool", "heat_cool", "auto", "dry", "fan_only")));

    /** @throws IllegalArgumentException if the entity's id is none */
    public EntityValue {
        requireId(entity);
    }

    /** The state of an entity. */
    public static EntityValue state(String entity) {
        return new EntityValue(entity, null);
    }

    /** An attribute of an entity. */
    public static EntityValue attribute(String entity, String attribute) {
        return new EntityValue(entity, attribute);
    }

    /**
     * The id of an entity.
     *
     * @throws IllegalArgumentException if it is none
     */
    public static String requireId(String entity) {
        if (!ID.matcher(entity).matches()) {
            throw new IllegalArgumentException("'" + entity
                    + "' is no entity's id; Home Assistant shows it in the entity's settings, such as light.kitchen");
        }
        return entity;
    }

    /**
     * What the state of an entity may be, besides {@code unavailable} and {@code unknown}; empty if its kind does not say
     * (Home Assistant's own entity classes; as of 2026.11).
     *
     * @param entity its id
     */
    public static Set<String> statesOf(String entity) {
        return STATES.getOrDefault(Entity.domain(entity), Set.of());
    }

    /** Empty if the entity has no such attribute now. */
    Optional<String> of(Entity now) {
        return attribute == null
                ? Optional.of(now.state())
                : Part.at("/" + attribute.replace("~", "~0").replace("/", "~1"))
                        .in(now.attributes().copy().toString());
    }

    /** For messages: {@code light.kitchen's brightness}. */
    @Override
    public String toString() {
        return attribute == null ? entity : entity + "'s " + attribute;
    }
}
