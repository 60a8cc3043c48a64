package org.evoloop.fleet.stream;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
    private final Map<String, Model.Takeover> takeovers = new HashMap<>();

    Rollouts(ReadOnlyKeyValueStore<String, byte[]> published, Library library) {
        this.published = published;
        this.library = library;
    }

    /** Reads them again; returns whether one has changed. */
    boolean refresh() {
        boolean changed = false;
        try (KeyValueIterator<String, byte[]> each = published.all()) {
            while (each.hasNext()) {
                KeyValue<String, byte[]> next = each.next();
                if (!Arrays.equals(seen.put(next.key, next.value), next.value)) {
                    read(next.key, next.value);
                    changed = true;
                }
            }
        }
        return changed;
    }

    private void read(String name, byte[] record) {
        takeovers.clear();
        try {
            Rollout rollout = Rollout.read(name, record);
            all.put(name, rollout);
            takeover(rollout);
        } catch (Refusal | ModelException e) {
            all.remove(name);
            LOG.error("the rollout {} is ignored: {}", name, e.getMessage());
        }
    }

    /** The switch due at {@code device}, which has the models {@code version}; null if there is none. */
    Model.@Nullable Takeover of(String device, String version) {
        for (Rollout rollout : all.values()) {
            String leaves = rollout.isRolling() ? rollout.from() : rollout.to();
            if (leaves.equals(version) && rollout.takesIn(device)) {
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
