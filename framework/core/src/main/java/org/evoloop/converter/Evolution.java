package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.List;
import org.evoloop.core.Output;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Carried;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Mapping;

/**
 * What a running converter is to evolve to, see {@link SystemEventConverter#evolve}.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Evolution {
    /** How long it is tried unless something else is said. */
    public static final Duration USUAL_DEADLINE = Duration.ofSeconds(30);

    private final StateKnowledge next;
    private final Mapping mapping;
    private final Duration deadline;
    private final Duration idle;
    private final Probation probation;
    private final boolean wayBack;

    /**
     * What became of the current states.
     *
     * @param model the name of the present new model
     * @param before in terms of the models before
     * @param after in terms of the present ones, once {@code steps} have been sent
     * @param steps what is sent to the device so that both models can stand together
     * @param carried what became of the timers and the function of the new model's state
     * @param pause how long no event could begin; what ends and begins with the models is part of it
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

        static Result of(Output.Evolved evolved, Duration pause) {
            Fate.Maps fate = evolved.fate();
            return new Result(
                    evolved.occurrence().model(), evolved.before(), fate.to(), fate.steps(), fate.carried(), pause);
        }
    }

    private Evolution(
            StateKnowledge next,
            Mapping mapping,
            Duration deadline,
            Duration idle,
            Probation probation,
            boolean wayBack) {
        this.next = requireNonNull(next, "the next knowledge is null");
        this.mapping = requireNonNull(mapping, "the mapping is null");
        this.deadline = positive(deadline, "the deadline");
        this.idle = positive(idle, "the idle time");
        this.probation = requireNonNull(probation, "the probation is null");
        this.wayBack = wayBack;
    }

    private static Duration positive(Duration duration, String what) {
        if (requireNonNull(duration, what + " is null").isNegative()) {
            throw new IllegalArgumentException(what + " is " + duration + ", allowed is 0 and more");
        }
        return duration;
    }

    /** Everything goes by name, within {@link #USUAL_DEADLINE}, without probation. */
    public static Evolution to(StateKnowledge next) {
        return new Evolution(next, Mapping.byName(), USUAL_DEADLINE, Duration.ZERO, Probation.NONE, true);
    }

    /** The same with states, timers and functions that do not go by their names. */
    public Evolution withMapping(Mapping names) {
        return new Evolution(next, names, deadline, idle, probation, wayBack);
    }

    /** The same within this time. */
    public Evolution withDeadline(Duration time) {
        return new Evolution(next, mapping, time, idle, probation, wayBack);
    }

    /** The same as soon as nothing has happened for this time. */
    public Evolution whenIdle(Duration time) {
        return new Evolution(next, mapping, deadline, time, probation, wayBack);
    }

    /** The same, which is rolled back if anything goes wrong during {@code time}. */
    public Evolution withProbation(Probation time) {
        return new Evolution(next, mapping, deadline, idle, time, wayBack);
    }

    /** The same, also if no way leads back to the present models from some of the next ones' states. */
    public Evolution withoutWayBack() {
        return new Evolution(next, mapping, deadline, idle, probation, false);
    }

    StateKnowledge next() {
        return next;
    }

    Mapping mapping() {
        return mapping;
    }

    Duration deadline() {
        return deadline;
    }

    Duration idle() {
        return idle;
    }

    /** How long it is on trial. */
    public Probation probation() {
        return probation;
    }

    boolean needsWayBack() {
        return wayBack;
    }
}
