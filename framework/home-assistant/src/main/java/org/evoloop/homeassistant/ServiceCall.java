package org.evoloop.homeassistant;

import org.evoloop.evolution.Values;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.Template;
import org.jspecify.annotations.Nullable;

/**
 * A call of one of Home Assistant's services, which its pages call actions.
 *
 * <p>Threading: immutable.
 *
 * @param service such as {@code light.turn_on}
 * @param entity to which it is applied; null if to none
 * @param data further fields, a JSON object such as {@code {"brightness": 128}}, which may contain an event's values, see
 *     {@link Template}
 * @since 0.1
 */
public record ServiceCall(String service, @Nullable String entity, String data) {
    /** @throws IllegalArgumentException if one of them is not what it must be */
    public ServiceCall {
        if (!service.matches("[a-z0-9_]+\\.[a-z0-9_]+")) {
            throw new IllegalArgumentException("'" + service + "' is no service; write one such as light.turn_on");
        }
        if (entity != null) {
            EntityValue.requireId(entity);
        }
        // A number is valid wherever a value may be.
        JsonRecord.of(data.replaceAll("\\$\\{[A-Za-z_][A-Za-z0-9_.-]*}", "0"));
    }

    /** Without data. */
    public static ServiceCall of(String service, @Nullable String entity) {
        return new ServiceCall(service, entity, "{}");
    }

    /** The request with the values of an event. */
    JsonObject request(Values values) {
        int dot = service.indexOf('.');
        JsonObject request = new JsonObject()
                .put("type", "call_service")
                .put("domain", service.substring(0, dot))
                .put("service", service.substring(dot + 1));
        String filled = Template.of(data).with(values);
        if (!filled.equals("{}")) {
            request.put("service_data", JsonRecord.of(filled).copy());
        }
        return entity == null ? request : request.put("target", new JsonObject().put("entity_id", entity));
    }

    /** For messages. */
    String failed(@Nullable Throwable why) {
        return "Home Assistant has not carried out " + this + (why == null ? "" : ": " + why.getMessage());
    }

    /** For messages: {@code light.turn_on of light.kitchen}. */
    @Override
    public String toString() {
        return entity == null ? service : service + " of " + entity;
    }
}
