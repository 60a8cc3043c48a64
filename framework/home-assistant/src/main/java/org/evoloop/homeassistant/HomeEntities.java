package org.evoloop.homeassistant;

import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.Part;
import org.evoloop.statemachine.Names;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What Home Assistant says of the entities that somebody listens to, and what is wrong with them. What is wrong is logged
 * once, until it has ended.
 *
 * <p>Threading: listeners are added before the connection is opened, and are called one at a time; the rest is thread-safe.
 */
final class HomeEntities {
    private static final Part DISABLED_BY = Part.at("/disabled_by");
    private static final Logger LOG = LoggerFactory.getLogger(HomeEntities.class);

    private final Map<String, List<Listener>> listeners = new TreeMap<>();
    private final Map<String, Entity> known = new ConcurrentHashMap<>();
    private final Map<String, Wrong> wrong = new ConcurrentHashMap<>();
    private final Map<String, String> places = new ConcurrentHashMap<>();
    /** Of those that somebody has renamed or disabled: what to do. */
    private final Map<String, String> hidden = new ConcurrentHashMap<>();

    /** Hears of one entity. */
    interface Listener {
        /**
         * The entity is in this state.
         *
         * @param old whether it may have been so for long
         */
        void hear(Entity now, boolean old);

        /** The entity cannot be reached. */
        void lost(String why);
    }

    private record Wrong(String text, Instant since) {}

    /** Where it is written what this key is about; the first place counts. */
    void place(String key, String place) {
        places.putIfAbsent(key, place);
    }

    void add(String entity, Listener listener) {
        listeners.computeIfAbsent(entity, first -> new CopyOnWriteArrayList<>()).add(listener);
    }

    Collection<String> ids() {
        return listeners.keySet();
    }

    /** An event of {@code subscribe_entities}: {@code a} are those that are there now, {@code c} changes, {@code r} gone. */
    void hear(JsonRecord event) {
        event.inner("a")
                .ifPresent(added -> added.names().forEach(id -> added.inner(id).ifPresent(now -> is(now(id, now)))));
        event.inner("c")
                .ifPresent(changed ->
                        changed.names().forEach(id -> changed.inner(id).ifPresent(how -> changes(id, how))));
        event.texts("r").forEach(this::isGone);
    }

    private static Entity now(String id, JsonRecord compressed) {
        return new Entity(id, compressed.text("s"), compressed.inner("a").orElseGet(() -> JsonRecord.of("{}")));
    }

    private void changes(String id, JsonRecord how) {
        Entity before = known.get(id);
        if (before == null) {
            return;
        }
        List<String> without = how.inner("-").map(gone -> gone.texts("a")).orElse(List.of());
        JsonRecord more = how.inner("+").orElse(how);
        JsonRecord none = JsonRecord.of("{}");
        is(new Entity(
                id,
                more.text("s", before.state()),
                before.attributes().with(more.inner("a").orElse(none), without)));
    }

    private void is(Entity now) {
        Entity before = known.put(now.id(), now);
        if (now.isHere()) {
            if (wrong.remove(now.id()) != null) {
                LOG.info("{} is there again", now.id());
            }
            boolean old = before == null || !before.isHere();
            listeners.getOrDefault(now.id(), List.of()).forEach(each -> each.hear(now, old));
        } else {
            note(now.id(), now.id() + " is " + now.state() + " in Home Assistant");
        }
    }

    private void isGone(String id) {
        known.remove(id);
        note(
                id,
                hidden.getOrDefault(
                        id, id + " is no longer in Home Assistant; if it was removed or renamed, name another entity"));
    }

    /** An event of the entity registry. */
    void registered(JsonRecord event) {
        JsonRecord data = event.inner("data").orElse(event);
        String id = data.text("entity_id", "");
        String before = data.text("old_entity_id", id);
        // What has changed is told with the values that were there before.
        JsonRecord changed = data.inner("changes").orElseGet(() -> JsonRecord.of("{}"));
        hidden.remove(id);
        if (!before.equals(id)) {
            hides(before, before + " is called " + id + " now; write that name");
        } else if (changed.has("disabled_by") && !isDisabled(changed)) {
            disabled(id);
        }
    }

    /** Whether an entry of the registry is that of an entity that somebody has disabled. */
    static boolean isDisabled(JsonRecord entry) {
        return DISABLED_BY.in(entry.copy().toString()).isPresent();
    }

    /** Somebody has disabled it, so that it has no state. */
    void disabled(String id) {
        hides(id, id + " is disabled in Home Assistant; enable it in its settings");
    }

    private void hides(String id, String why) {
        if (listeners.containsKey(id)) {
            hidden.put(id, why);
            if (wrong.containsKey(id)) {
                isGone(id);
            }
        }
    }

    /** After a connect: what of them is not there, although Home Assistant has started. */
    void require(Collection<String> all, String place) {
        listeners.keySet().stream()
                .filter(id -> !all.contains(id))
                .forEach(id -> note(
                        id,
                        hidden.getOrDefault(
                                id,
                                place + " has no entity " + id
                                        + (Names.meant(id, all).isEmpty()
                                                ? "; the entity's settings in Home Assistant show its id"
                                                : Names.meant(id, all)))));
    }

    /** Something is wrong with an entity, or with what is asked of it; tells those that listen to it. */
    void note(String key, String what) {
        String place = places.get(key);
        String text = place == null ? what : place + ": " + what;
        Wrong before = wrong.get(key);
        if (before == null || !before.text().equals(text)) {
            wrong.put(key, new Wrong(text, before == null ? Instant.now() : before.since()));
            LOG.warn("{}", text);
        }
        listeners.getOrDefault(key, List.of()).forEach(each -> each.lost(text));
    }

    /** Nothing is wrong with what is asked. */
    void isRight(String key) {
        wrong.remove(key);
    }

    /** What is wrong with the first of these; null if nothing is. */
    @Nullable
    String wrongWith(Collection<String> keys) {
        return keys.stream()
                .map(wrong::get)
                .filter(each -> each != null)
                .map(Wrong::text)
                .findFirst()
                .orElse(null);
    }

    /** Since when something is wrong with the first of these. */
    Optional<Instant> wrongSince(Collection<String> keys) {
        return keys.stream()
                .map(wrong::get)
                .filter(each -> each != null)
                .map(Wrong::since)
                .findFirst();
    }

    /** What an entity said last; null if nothing is known. */
    @Nullable
    Entity now(String id) {
        Entity now = known.get(id);
        return now != null && now.isHere() ? now : null;
    }

    /** The connection is lost. */
    void lost(String why) {
        known.clear();
        listeners.values().forEach(each -> each.forEach(listener -> listener.lost(why)));
    }
}
