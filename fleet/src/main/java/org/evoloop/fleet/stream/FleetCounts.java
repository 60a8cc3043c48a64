package org.evoloop.fleet.stream;

import io.micrometer.core.instrument.FunctionCounter;
import io.micrometer.core.instrument.MeterRegistry;
import io.micrometer.core.instrument.binder.MeterBinder;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.LongAdder;
import org.evoloop.fleet.wire.Refusal;

/**
 * What an instance counts since its start: {@code evoloop.fleet.results} by {@code result}, {@code success} or {@code
 * failure} as rollouts count them, and {@code evoloop.fleet.dead.letters} by {@code reason}. A record that is processed
 * again, since its transaction was aborted, counts again.
 *
 * <p>Threading: thread-safe.
 */
final class FleetCounts implements MeterBinder {
    private final LongAdder successes = new LongAdder();
    private final LongAdder failures = new LongAdder();
    private final Map<Refusal.Reason, LongAdder> deadLetters = new EnumMap<>(Refusal.Reason.class);

    FleetCounts() {
        for (Refusal.Reason reason : Refusal.Reason.values()) {
            deadLetters.put(reason, new LongAdder());
        }
    }

    void results(long good, long bad) {
        successes.add(good);
        failures.add(bad);
    }

    void refused(Refusal.Reason reason) {
        deadLetters.computeIfPresent(reason, (same, count) -> {
            count.increment();
            return count;
        });
    }

    @Override
    public void bindTo(MeterRegistry registry) {
        result(registry, "success", successes);
        result(registry, "failure", failures);
        deadLetters.forEach(
                (reason, count) -> FunctionCounter.builder("evoloop.fleet.dead.letters", count, LongAdder::doubleValue)
                        .description("Records that could not be processed")
                        .tag("reason", reason.name().toLowerCase(Locale.ROOT).replace('_', '-'))
                        .register(registry));
    }

    private static void result(MeterRegistry registry, String result, LongAdder count) {
        FunctionCounter.builder("evoloop.fleet.results", count, LongAdder::doubleValue)
                .description("What became of occurrences at devices")
                .tag("result", result)
                .register(registry);
    }
}
