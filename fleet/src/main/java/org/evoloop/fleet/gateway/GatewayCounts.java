package org.evoloop.fleet.gateway;

import io.micrometer.core.instrument.FunctionCounter;
import io.micrometer.core.instrument.MeterRegistry;
import io.micrometer.core.instrument.binder.MeterBinder;
import java.util.concurrent.atomic.LongAdder;

/**
 * What a gateway counts since its start: {@code evoloop.gateway.records} by {@code step}, {@code stored} or {@code sent};
 * {@code evoloop.gateway.commands} by {@code outcome}, {@code published} or {@code failed}.
 *
 * <p>Threading: thread-safe.
 */
final class GatewayCounts implements MeterBinder {
    final LongAdder stored = new LongAdder();
    final LongAdder sent = new LongAdder();
    final LongAdder published = new LongAdder();
    final LongAdder failed = new LongAdder();

    @Override
    public void bindTo(MeterRegistry registry) {
        count(registry, "evoloop.gateway.records", "Records of devices", "step", "stored", stored);
        count(registry, "evoloop.gateway.records", "Records of devices", "step", "sent", sent);
        count(registry, "evoloop.gateway.commands", "Commands for devices", "outcome", "published", published);
        count(registry, "evoloop.gateway.commands", "Commands for devices", "outcome", "failed", failed);
    }

    private static void count(
            MeterRegistry registry, String name, String description, String tag, String value, LongAdder count) {
        FunctionCounter.builder(name, count, LongAdder::doubleValue)
                .description(description)
                .tag(tag, value)
                .register(registry);
    }
}
