package org.evoloop.engine;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * The part of a situation that decides how it can continue: equal for situations that differ only in counters and in
 * the time. Numbers are replaced by the order of their first occurrence, visits and times by whether they are the
 * present ones.
 */
final class Likeness {
    private final Snapshot now;
    private final World world;
    private final Map<Long, Integer> numbers = new HashMap<>();

    private Likeness(Snapshot now, World world) {
        this.now = now;
        this.world = world;
    }

    static List<Object> of(Snapshot now, World world) {
        Likeness likeness = new Likeness(now, world);
        List<Object> whole = likeness.ofCore();
        whole.addAll(likeness.ofWorld());
        return whole;
    }

    private List<Object> ofCore() {
        Snapshot.OpenVisit visit = now.visit();
        return list(
                now.open(),
                now.at(),
                now.steps() > 0,
                ofWork(now.work()),
                now.waiting().stream().map(this::of).toList(),
                ofDoubt(now.doubt()),
                visit.number() > 0,
                visit.over(),
                visit.by(),
                List.copyOf(visit.deadlines().keySet()),
                now.losing(),
                now.followOwed());
    }

    private List<Object> ofWorld() {
        return list(
                world.device,
                world.unreported.stream().map(this::of).toList(),
                of(world.flight),
                world.landed,
                of(world.stray),
                world.asked == null ? null : world.asked.getClass(),
                world.answer,
                world.plans,
                world.mayBeApart,
                world.misled,
                world.functionOf == now.visit().number(),
                world.phase,
                world.evolved,
                world.left);
    }

    private static List<Object> list(@Nullable Object... members) {
        return new ArrayList<>(Arrays.asList(members));
    }

    private int of(long number) {
        return numbers.computeIfAbsent(number, unknown -> numbers.size());
    }

    private @Nullable Object ofWork(@Nullable Work work) {
        return work == null
                ? null
                : list(
                        of(work.pending()),
                        work.decision(),
                        work.taken(),
                        work.pending().stepsBefore() < now.steps() - work.stepsSent(),
                        work.effectsRun(),
                        work.failedEffects().isEmpty(),
                        work.stage(),
                        ofAll(work.meanwhile()));
    }

    private @Nullable Object ofDoubt(@Nullable Doubt doubt) {
        return doubt == null
                ? null
                : list(
                        of(doubt.number()),
                        doubt.step(),
                        doubt.stepsBefore() < 0,
                        doubt.stepsBefore() == now.steps(),
                        ofAll(doubt.meanwhile()),
                        doubt.settled());
    }

    private Object of(Pending pending) {
        return list(
                of(pending.number()),
                of(pending.occurrence()),
                pending.from(),
                pending.own(),
                pending.stepsBefore() == now.steps(),
                pending.attempts(),
                age(pending));
    }

    /** Of a press, as far as it makes a difference. */
    private long age(Pending pending) {
        Duration limit = world.rules().pressAge();
        return limit.equals(Rules.ANY_AGE) || !pending.mayBeLost()
                ? 0
                : Math.min(now.nowNanos() - pending.occurrence().observedNanos(), limit.toNanos() + 1);
    }

    private Object of(Occurrence occurrence) {
        long visit = occurrence.visit();
        Object when =
                visit == Occurrence.ANY_VISIT ? "any" : visit == now.visit().number() ? "now" : "before";
        if (occurrence instanceof Occurrence.Heard heard) {
            return list(heard.event(), heard.source(), heard.deviceActed(), heard.holding(), when);
        }
        if (occurrence instanceof Occurrence.Found found) {
            return list(found.state(), now.steps() > 0 && found.observedNanos() < now.lastStepNanos());
        }
        return list(occurrence.getClass(), occurrence instanceof Occurrence.Asked asked ? asked.event() : "", when);
    }

    private Object ofAll(List<Occurrence> occurrences) {
        return occurrences.stream().map(this::of).toList();
    }

    private Object of(Token token) {
        return token instanceof Token.Effect effect ? of(effect.number()) : token;
    }

    private @Nullable Object of(World.@Nullable Flight flight) {
        return flight == null ? null : list(of(flight.number()), flight.step());
    }
}
