package org.evoloop.models;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.evoloop.converter.Drift;
import org.evoloop.engine.Input;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.journal.JournalFiles;
import org.evoloop.journal.JournalRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.jspecify.annotations.Nullable;

/**
 * What journals have recorded of a device. An act is an event that was sent and obeyed, or that the device did by itself. It
 * leads to the state that the device reports last before its next act, within 10 s; without a report, nobody knows.
 */
final class Recorded {
    private static final long SOON = Duration.ofSeconds(10).toNanos();

    private final Map<Drift.Edge, Integer> counts = new LinkedHashMap<>();
    private final Set<Event> spontaneous = new HashSet<>();
    private final Map<Long, Iterator<Step>> plans = new HashMap<>();
    private final Map<Long, Step> sending = new HashMap<>();
    private @Nullable State initial;
    private @Nullable State at;

    // The last act, until the next; null if there is none.
    private @Nullable State source;
    private @Nullable Event event;
    private @Nullable State target;
    private long since;

    /** Reads a journal, oldest record first. */
    void read(JournalFiles files) {
        files.read(this::take);
        forget();
    }

    private void take(JournalRecord each) {
        Input input = each.input();
        if (input instanceof Input.Planned planned) {
            plans.put(
                    planned.number(),
                    planned.decision().steps().stream()
                            .filter(step -> !step.byDevice())
                            .iterator());
        } else if (input instanceof Input.Sending begun) {
            Iterator<Step> steps = plans.get(begun.number());
            if (steps != null && steps.hasNext()) {
                sending.put(begun.number(), steps.next());
            }
        } else if (input instanceof Input.Sent sent) {
            Step step = sending.remove(sent.number());
            if (step != null) {
                act(step.source(), step.trigger(), each.nanos());
            }
        } else if (input instanceof Input.Observed observed) {
            observed(observed.occurrence(), each.nanos());
        } else if (input instanceof Input.Located located && located.state() != null) {
            reported(located.state(), each.nanos());
        } else if (input instanceof Input.Opened
                || input instanceof Input.Changed
                || input instanceof Input.Recovered) {
            forget();
            plans.clear();
            sending.clear();
        }
        at = each.where().original();
    }

    private void observed(Occurrence occurrence, long nanos) {
        State before = at;
        if (occurrence instanceof Occurrence.Found found) {
            reported(found.state(), nanos);
        } else if (occurrence instanceof Occurrence.Heard heard && heard.deviceActed() && before != null) {
            act(before, heard.event().trigger(), nanos);
            if (heard.source() == Source.DEVICE) {
                spontaneous.add(heard.event().trigger());
            }
        }
    }

    private void act(State from, Event what, long nanos) {
        forget();
        source = from;
        event = what;
        since = nanos;
        initial = initial == null ? from : initial;
    }

    private void reported(State state, long nanos) {
        initial = initial == null ? state : initial;
        if (source != null && nanos - since <= SOON) {
            target = state;
        }
    }

    /** The last act is over. */
    private void forget() {
        if (source != null) {
            counts.merge(new Drift.Edge(source, event, target, 1), 1, Integer::sum);
        }
        source = null;
        target = null;
    }

    /** Everything that was seen, with its counts, in the order in which it was first seen. */
    List<Drift.Edge> edges() {
        return counts.entrySet().stream()
                .map(each -> new Drift.Edge(
                        each.getKey().source(),
                        each.getKey().event(),
                        each.getKey().target(),
                        each.getValue()))
                .toList();
    }

    /** A machine of the transitions that were seen, each to where it led most often; null if none was seen. */
    @Nullable
    StateMachine machine(String name) {
        State first = initial;
        Drift seen = new Drift(
                0, edges().stream().filter(edge -> edge.target() != null).toList());
        if (first == null || seen.edges().isEmpty()) {
            return null;
        }
        StateMachineBuilder empty = StateMachine.named(name).initial(first.name());
        List<Event> own = new ArrayList<>(spontaneous);
        own.retainAll(seen.edges().stream().map(Drift.Edge::event).toList());
        own.forEach(empty::spontaneous);
        return seen.explained(empty.build());
    }

    /** What the declared model does not have. */
    Drift additions(StateMachine declared) {
        return new Drift(
                counts.values().stream().mapToInt(Integer::intValue).sum(),
                edges().stream()
                        .filter(edge -> !has(declared, edge) && !isOutnumbered(declared, edge))
                        .toList());
    }

    /** Whether the event led to where it is declared to lead at least as often. */
    private boolean isOutnumbered(StateMachine declared, Drift.Edge edge) {
        State drawn = declared.nextState(edge.source(), Objects.requireNonNull(edge.event()))
                .orElse(null);
        return drawn != null
                && counts.getOrDefault(new Drift.Edge(edge.source(), edge.event(), drawn, 1), 0) >= edge.count();
    }

    private static boolean has(StateMachine declared, Drift.Edge edge) {
        Event event = Objects.requireNonNull(edge.event());
        State drawn = declared.nextState(edge.source(), event).orElse(null);
        State target = edge.target();
        return drawn == null ? edge.source().equals(target) : target == null || drawn.equals(target);
    }

    /** Edges of which others with the same event lead elsewhere: what a machine cannot have. */
    List<Drift.Edge> ambiguous() {
        List<Drift.Edge> all = edges();
        return all.stream()
                .filter(edge -> edge.target() != null
                        && all.stream()
                                .anyMatch(other -> other.target() != null
                                        && other.source().equals(edge.source())
                                        && Objects.equals(other.event(), edge.event())
                                        && !edge.target().equals(other.target())))
                .toList();
    }
}
