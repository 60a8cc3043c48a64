package org.evoloop.homeassistant;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.Part;
import org.evoloop.statemachine.Names;

/**
 * What is checked after each connect: that there are the entities, that they take the services, and that none is what the
 * converter shows itself.
 *
 * <p>Threading: for one thread.
 */
final class HomeChecks {
    private static final String NONE = "{}";

    private final HomeSession session;
    private final String place;
    private final Map<String, JsonRecord> states = new HashMap<>();

    HomeChecks(HomeSession session, HomeAddress place) throws HomeException, InterruptedException {
        this.session = session;
        this.place = place.toString();
        for (JsonRecord state : session.ask("get_states").each("result")) {
            states.put(state.text("entity_id"), state.inner("attributes").orElseGet(() -> JsonRecord.of(NONE)));
        }
    }

    /** Notes what is wrong with the entities and the services, and what is no longer. */
    void run(HomeEntities entities, Collection<ServiceCall> calls, Collection<String> own, Expected expected)
            throws HomeException, InterruptedException {
        JsonRecord entries = entries(entities.ids());
        for (String id : entities.ids()) {
            entries.inner(id).filter(HomeEntities::isDisabled).ifPresent(entry -> entities.disabled(id));
        }
        entities.require(states.keySet(), place);
        requireOthers(entities, entries, own);
        expected.check(states, entities);
        JsonRecord services = session.ask("get_services").inner("result").orElseGet(() -> JsonRecord.of(NONE));
        for (ServiceCall call : calls) {
            Optional<String> mistake = mistake(call, services);
            mistake.ifPresentOrElse(
                    text -> entities.note(call.toString(), text), () -> entities.isRight(call.toString()));
        }
    }

    /** A converter whose input is its own output would answer itself for ever. */
    private static void requireOthers(HomeEntities entities, JsonRecord entries, Collection<String> own) {
        for (String id : entities.ids()) {
            boolean shown = entries.inner(id)
                    .filter(entry -> "mqtt".equals(entry.text("platform", "")))
                    .filter(entry -> own.stream()
                            .anyMatch(each -> entry.text("unique_id", "").startsWith("evoloop_" + each + "_")))
                    .isPresent();
            if (shown) {
                entities.note(
                        loop(id),
                        id + " is what this converter itself shows in Home Assistant, and its input would be its own "
                                + "output; name the entity of the device or the controller");
            } else {
                entities.isRight(loop(id));
            }
        }
    }

    /** What the registry says of entities; nothing if this Home Assistant cannot be asked. */
    private JsonRecord entries(Collection<String> ids) throws HomeException, InterruptedException {
        JsonObject question = new JsonObject()
                .put("type", "config/entity_registry/get_entries")
                .putTexts("entity_ids", ids);
        try {
            return session.ask(question, event -> {}).inner("result").orElseGet(() -> JsonRecord.of(NONE));
        } catch (HomeException refused) {
            if (refused.hasCode("unknown_command")) {
                return JsonRecord.of(NONE);
            }
            throw refused;
        }
    }

    /** The key of what is wrong with an entity that is the converter's own. */
    static String loop(String id) {
        return id + " (own)";
    }

    private Optional<String> mistake(ServiceCall call, JsonRecord services) {
        String domain = Entity.domain(call.service());
        String name = call.service().substring(domain.length() + 1);
        JsonRecord ofDomain = services.inner(domain).orElseGet(() -> JsonRecord.of(NONE));
        JsonRecord service = ofDomain.inner(name).orElse(null);
        if (service == null) {
            return Optional.of(place + " has no service " + call.service() + Names.hint(call.service(), all(services)));
        }
        String entity = call.entity();
        if (entity == null || takes(service, entity)) {
            return Optional.empty();
        }
        List<String> others = ofDomain.names().stream()
                .filter(each ->
                        ofDomain.inner(each).map(other -> takes(other, entity)).orElse(false))
                .map(each -> domain + "." + each)
                .sorted()
                .toList();
        return Optional.of(entity + " does not support " + call.service()
                + (others.isEmpty() || !Entity.domain(entity).equals(domain)
                        ? ", which is for entities of other kinds"
                        : "; it supports " + String.join(", ", others)));
    }

    private static List<String> all(JsonRecord services) {
        List<String> all = new ArrayList<>();
        for (String domain : services.names()) {
            services.inner(domain).ifPresent(names -> names.names().forEach(name -> all.add(domain + "." + name)));
        }
        return all;
    }

    /** Whether one of the service's filters of entities lets this one pass; without any, all pass. */
    private boolean takes(JsonRecord service, String entity) {
        JsonRecord attributes = states.get(entity);
        List<JsonRecord> filters =
                service.inner("target").map(target -> target.each("entity")).orElse(List.of());
        if (attributes == null || filters.isEmpty()) {
            return true;
        }
        return filters.stream().anyMatch(filter -> {
            List<String> domains = filter.texts("domain");
            return (domains.isEmpty() || domains.contains(Entity.domain(entity)))
                    && hasFeature(filter.copy().toString(), attributes.number("supported_features", 0));
        });
    }

    /** Whether all bits of one of the filter's features are there; a feature is a number, or a list of them. */
    private static boolean hasFeature(String filter, long features) {
        if (!at(filter, "0").isPresent() && !at(filter, "0/0").isPresent()) {
            return true;
        }
        for (int each = 0;
                at(filter, each + "").isPresent() || at(filter, each + "/0").isPresent();
                each++) {
            long needed = at(filter, each + "").map(Long::valueOf).orElse(0L);
            for (int part = 0; at(filter, each + "/" + part).isPresent(); part++) {
                needed |= Long.parseLong(at(filter, each + "/" + part).orElse("0"));
            }
            if ((features & needed) == needed) {
                return true;
            }
        }
        return false;
    }

    private static Optional<String> at(String filter, String index) {
        return Part.at("/supported_features/" + index).in(filter);
    }
}
