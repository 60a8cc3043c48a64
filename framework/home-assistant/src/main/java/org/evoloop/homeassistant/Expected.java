package org.evoloop.homeassistant;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.Names;

/**
 * What is expected of entities: attributes, and texts that a state or an attribute may be. What an entity never says is
 * only a note: an attribute may come later.
 *
 * <p>Threading: completed by one thread before the connection is opened.
 */
final class Expected {
    /** By the name of an attribute: the attribute that lists what it may be; the state has the empty name. */
    private static final Map<String, List<String>> LISTS = Map.of(
            "",
            List.of("options", "hvac_modes"),
            "event_type",
            List.of("event_types"),
            "effect",
            List.of("effect_list"),
            "source",
            List.of("source_list"),
            "sound_mode",
            List.of("sound_mode_list"));

    private final Map<EntityValue, Set<String>> texts = new LinkedHashMap<>();

    void add(EntityValue value, Set<String> more) {
        texts.computeIfAbsent(value, first -> new LinkedHashSet<>()).addAll(more);
    }

    /**
     * Notes what these entities do not have, and what is no longer missing.
     *
     * @param attributes by the entity's id, of those that are there
     */
    void check(Map<String, JsonRecord> attributes, HomeEntities notes) {
        texts.forEach((value, wanted) -> {
            JsonRecord now = attributes.get(value.entity());
            if (now != null) {
                mistake(value, wanted, now)
                        .ifPresentOrElse(
                                text -> notes.note(value.toString(), text), () -> notes.isRight(value.toString()));
            }
        });
    }

    private static Optional<String> mistake(EntityValue value, Set<String> wanted, JsonRecord now) {
        String attribute = value.attribute();
        if (attribute != null && !now.has(attribute)) {
            return Optional.of(
                    value.entity() + " has no attribute " + attribute + " now" + Names.hint(attribute, now.names()));
        }
        List<String> known = known(attribute == null ? "" : attribute, now);
        for (String each : known.isEmpty() ? Set.<String>of() : wanted) {
            if (!known.contains(each)) {
                return Optional.of(value + " is never '" + each + "'" + Names.hint(each, known));
            }
        }
        return Optional.empty();
    }

    /** What it may be; empty if that is not known. */
    private static List<String> known(String attribute, JsonRecord now) {
        List<String> lists = new ArrayList<>(LISTS.getOrDefault(attribute, List.of()));
        // As for preset_mode.
        lists.add(attribute + "s");
        for (String list : lists) {
            try {
                List<String> known = now.texts(list);
                if (!known.isEmpty()) {
                    return known;
                }
            } catch (IllegalArgumentException otherKind) {
                // It is no such list.
            }
        }
        return List.of();
    }
}
