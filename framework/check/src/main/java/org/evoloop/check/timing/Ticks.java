package org.evoloop.check.timing;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import org.evoloop.evolution.Timers;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * The unit in which time is counted: the greatest common divisor of all relevant durations. With closed intervals this
 * loses nothing: whatever can happen at all can also happen at whole ticks (Henzinger, Manna and Pnueli, What good are
 * digital clocks?, ICALP 1992).
 */
record Ticks(long nanos) {

    /** @param properties that are judged at the same time */
    static Ticks of(
            TimeRules rules, StateMachine original, StateMachine evolved, Timers timers, List<TimeForm> properties) {
        List<Long> lengths = new ArrayList<>();
        for (State state : evolved.states()) {
            timers.of(state).values().forEach(delay -> lengths.add(delay.toNanos()));
        }
        for (State state : original.states()) {
            original.timers(state).values().forEach(delay -> lengths.add(delay.toNanos()));
        }
        for (Assumption assumption : rules.assumptions()) {
            if (assumption instanceof Assumption.Takes takes) {
                add(takes.span(), lengths);
            } else if (assumption instanceof Assumption.Comes comes) {
                add(comes.span(), lengths);
            } else if (assumption instanceof Assumption.Gap gap) {
                lengths.add(gap.minNanos());
            }
        }
        properties.forEach(form -> lengths.addAll(form.nanos()));
        long common = lengths.stream()
                .mapToLong(Long::longValue)
                .reduce(
                        0,
                        (one, other) -> BigInteger.valueOf(one)
                                .gcd(BigInteger.valueOf(other))
                                .longValue());
        return new Ticks(common == 0 ? 1_000_000_000L : common);
    }

    private static void add(Span span, List<Long> lengths) {
        LongStream.of(span.minNanos(), span.maxNanos()).forEach(lengths::add);
    }

    /** @throws TooLargeException if that is more than can be counted */
    int of(long length) {
        long count = length / nanos;
        if (count > Integer.MAX_VALUE / 8) {
            throw new TooLargeException(Span.length(length) + " is " + count + " ticks of " + Span.length(nanos));
        }
        return (int) count;
    }

    long nanos(long count) {
        return count * nanos;
    }
}
