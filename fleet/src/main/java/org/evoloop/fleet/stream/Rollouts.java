package org.evoloop.fleet.stream;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.apache.kafka.streams.KeyValue;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.ReadOnlyKeyValueStore;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The published rollouts, as of the last {@link #refresh}. */
final class Rollouts {
    private static final Logger LOG = LoggerFactory.getLogger(Rollouts.class);

    private final ReadOnlyKeyValueStore<String, byte[]> published;
    private final Library library;
    private final Map<String, byte[]> seen = new HashMap<>();
    private final Map<String, Rollout> all = new TreeMap<>();

    /** Those whose models are not there yet. */
    private final Set<String> waiting = new HashSet<>();

    private final Map<String, Model.Takeover> takeovers = new HashMap<>();

    Rollouts(ReadOnlyKeyValueStore<String, byte[]> published, Library library) {
        this.published = published;
        this.library = library;
    }

    /** Reads them again; returns whether one has begun or changed. */
    boolean refresh() {
        boolean changed = false;
        Set<String> deleted = new HashSet<>(seen.keySet());
        try (KeyValueIterator<String, byte[]> each = published.all()) {
            while (each.hasNext()) {
                KeyValue<String, byte[]> next = each.next();
                deleted.remove(next.key);
                boolean isNew = !Arrays.equals(seen.get(next.key), next.value);
                if (isNew || waiting.contains(next.key)) {
                    forget(next.key);
                    seen.put(next.key, next.value);
                    changed |= read(next.key, next.value, isNew);
                }
            }
        }
        deleted.forEach(this::forget);
        return changed;
    }

    /** Returns false while it waits for its models. */
    private boolean read(String name, byte[] record, boolean isNew) {
        try {
            Rollout rollout = Rollout.read(name, record);
            takeover(rollout);
            all.put(name, rollout);
            return true;
        } catch (Refusal | ModelException e) {
            boolean waits = e instanceof Refusal refusal && refusal.reason() == Refusal.Reason.UNKNOWN_MODEL;
            if (waits) {
                // Its models may have been published before it: records of two topics come in any order.
                waiting.add(name);
            }
            if (isNew) {
                LOG.error("the rollout {} {}: {}", name, waits ? "waits" : "is ignored", e.getMessage());
            }
            return !waits;
        }
    }

    private void forget(String name) {
        seen.remove(name);
        waiting.remove(name);
        all.remove(name);
        takeovers.remove(name);
    }

    /** The switch due at {@code device}, which has the models {@code version}; null if there is none. */
    Model.@Nullable Takeover of(String device, String version) {
        for (Rollout rollout : all.values()) {
            if (rollout.leaves().equals(version) && rollout.takesIn(device)) {
                return takeover(rollout);
            }
        }
        return null;
    }

    /** The rollouts that brought {@code device} to {@code version} and count its results. */
    List<String> watching(String device, String version) {
        if (all.isEmpty()) {
            return List.of();
        }
        List<String> watching = new ArrayList<>();
        for (Rollout rollout : all.values()) {
            if (rollout.isRolling() && rollout.to().equals(version) && rollout.takesIn(device)) {
                watching.add(rollout.name());
            }
        }
        return watching;
    }

    boolean isEmpty() {
        return all.isEmpty();
    }

    private Model.Takeover takeover(Rollout rollout) {
        return takeovers.computeIfAbsent(
                rollout.name(), name -> rollout.takeover(library.model(rollout.from()), library.model(rollout.to())));
    }
}
