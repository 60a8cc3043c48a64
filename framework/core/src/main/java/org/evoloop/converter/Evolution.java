package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Carried;
import org.evoloop.migration.Mapping;

/**
 * The models to which a running converter is to evolve, and how; see {@link SystemEventConverter#evolve}.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Evolution {
    /** The default deadline. */
    public static final Duration USUAL_DEADLINE = Duration.ofSeconds(30);

    private final StateKnowledge next;
    private final Mapping mapping;
    private final Duration deadline;
    private final Duration idle;
    private final Probation probation;
    private final boolean wayBack;
    private final Consumer<String> waits;

    /**
     * The result of an evolution.
     *
     * @param model the name of the present new model
     * @param before the states before, in terms of the old models
     * @param after the states once {@code steps} have been sent, in terms of the present models
     * @param steps the steps sent to the device so that the states of both models are a reachable pair
     * @param carried how the timers and the function of the new model's state were carried over
     * @param pause how long no event could begin, including what ends and begins with the models
     */
    public record Result(
            String model,
            Configuration before,
            Configuration after,
            List<Step> steps,
            List<Carried> carried,
            Duration pause) {
        public Result {
            steps = List.copyOf(steps);
            carried = List.copyOf(carried);
        }
    }

    private Evolution(
            StateKnowledge next,
            Mapping mapping,
            Duration deadline,
            Duration idle,
            Probation probation,
            boolean wayBack,
            Consumer<String> waits) {
        this.next = requireNonNull(next, "the next knowledge is null");
        this.mapping = requireNonNull(mapping, "the mapping is null");
        this.deadline = positive(deadline, "the deadline");
        this.idle = positive(idle, "the idle time");
        this.probation = requireNonNull(probation, "the probation is null");
        this.wayBack = wayBack;
        this.waits = requireNonNull(waits, "what is told of a wait is null");
    }

    private static Duration positive(Duration duration, String what) {
        if (requireNonNull(duration, what + " is null").isNegative()) {
            throw new IllegalArgumentException(what + " is " + duration + ", allowed is 0 and more");
        }
        return duration;
    }

    /** An evolution to {@code next} that maps everything by name, within {@link #USUAL_DEADLINE}, without probation. */
    public static Evolution to(StateKnowledge next) {
        return new Evolution(next, Mapping.byName(), USUAL_DEADLINE, Duration.ZERO, Probation.NONE, true, why -> {});
    }

    /** A copy with this mapping for states, timers and functions that are not mapped by name. */
    public Evolution withMapping(Mapping names) {
        return new Evolution(next, names, deadline, idle, probation, wayBack, waits);
    }

    /** A copy with this deadline. */
    public Evolution withDeadline(Duration time) {
        return new Evolution(next, mapping, time, idle, probation, wayBack, waits);
    }

    /** A copy that takes over as soon as nothing has happened for this time. */
    public Evolution whenIdle(Duration time) {
        return new Evolution(next, mapping, deadline, time, probation, wayBack, waits);
    }

    /** A copy that is rolled back if anything goes wrong during the probation {@code time}. */
    public Evolution withProbation(Probation time) {
        return new Evolution(next, mapping, deadline, idle, time, wayBack, waits);
    }

    /** A copy that is also allowed if some states of the next models have no way back to the present ones. */
    public Evolution withoutWayBack() {
        return new Evolution(next, mapping, deadline, idle, probation, false, waits);
    }

    /** A copy that tells, once, why it has to wait if it is not possible at once. */
    public Evolution tellingWaits(Consumer<String> told) {
        return new Evolution(next, mapping, deadline, idle, probation, wayBack, told);
    }

    /** The knowledge to which it leads, with its models. */
    public StateKnowledge next() {
        return next;
    }

    /** How states, timers and functions are mapped that are not mapped by name. */
    public Mapping mapping() {
        return mapping;
    }

    /** Within which time it must become possible. */
    public Duration deadline() {
        return deadline;
    }

    /** How long nothing must have happened before; 0 if that does not matter. */
    public Duration idle() {
        return idle;
    }

    /** How long it is on trial. */
    public Probation probation() {
        return probation;
    }

    /** Is told why it has to wait. */
    public Consumer<String> waits() {
        return waits;
    }

    /** Whether every state of the next models needs a way back to the present ones. */
    public boolean needsWayBack() {
        return wayBack;
    }
}
