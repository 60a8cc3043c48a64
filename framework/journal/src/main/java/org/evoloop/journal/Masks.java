package org.evoloop.journal;

import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.engine.Doubt;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Work;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.jspecify.annotations.Nullable;

/**
 * The values of events that are left out of a journal.
 *
 * @param names names of values, such as {@code pin}, or of an event and its value, such as {@code unlock.pin}
 */
record Masks(Set<String> names) {
    static final Masks NONE = new Masks(Set.of());

    /** @throws IllegalArgumentException if a name is blank */
    Masks {
        names = Set.copyOf(names);
        if (names.stream().anyMatch(String::isBlank)) {
            throw new IllegalArgumentException(
                    "a masked value has no name; write that of a value, pin, or of an event and its value, unlock.pin");
        }
    }

    private boolean hides(String event, String value) {
        return names.contains(value) || names.contains(event + "." + value);
    }

    private Values of(String event, Values values) {
        Map<String, Object> all = values.byName();
        if (all.keySet().stream().noneMatch(value -> hides(event, value))) {
            return values;
        }
        Map<String, Object> shown = new TreeMap<>(all);
        shown.keySet().removeIf(value -> hides(event, value));
        return new Values(shown);
    }

    /** A copy of the snapshot without masked values. */
    Snapshot of(Snapshot known) {
        return names.isEmpty()
                ? known
                : new Snapshot(
                        known.open(),
                        known.at(),
                        of(known.doubt()),
                        known.steps(),
                        known.lastStepNanos(),
                        known.visit(),
                        known.waiting().stream().map(this::of).toList(),
                        known.losing(),
                        known.followOwed(),
                        of(known.work()),
                        known.tally(),
                        known.nowNanos());
    }

    private @Nullable Doubt of(@Nullable Doubt doubt) {
        return doubt == null
                ? null
                : new Doubt(
                        doubt.why(),
                        doubt.number(),
                        doubt.step(),
                        doubt.stepsBefore(),
                        doubt.meanwhile().stream().map(this::of).toList(),
                        doubt.settled(),
                        doubt.interrupted());
    }

    private @Nullable Work of(@Nullable Work work) {
        return work == null
                ? null
                : new Work(
                        of(work.pending()),
                        work.decision(),
                        work.taken(),
                        work.effectsRun(),
                        work.failedEffects(),
                        work.stage(),
                        work.meanwhile().stream().map(this::of).toList());
    }

    private Pending of(Pending pending) {
        return new Pending(
                pending.number(),
                of(pending.occurrence()),
                pending.from(),
                pending.own(),
                pending.stepsBefore(),
                pending.attempts(),
                pending.broken());
    }

    /** The occurrence without masked values. */
    Occurrence of(Occurrence occurrence) {
        if (names.isEmpty()) {
            return occurrence;
        } else if (occurrence instanceof Occurrence.Heard heard) {
            return new Occurrence.Heard(
                    heard.event(),
                    of(heard.event().name(), heard.values()),
                    heard.source(),
                    heard.deviceActed(),
                    heard.holding(),
                    heard.visit(),
                    heard.observedNanos());
        }
        return occurrence instanceof Occurrence.Asked asked
                ? new Occurrence.Asked(
                        asked.event(), of(asked.event().name(), asked.values()), asked.visit(), asked.observedNanos())
                : occurrence;
    }

    /** A copy with more names. */
    Masks and(Collection<String> more) {
        return new Masks(Stream.concat(names.stream(), more.stream()).collect(Collectors.toSet()));
    }
}
