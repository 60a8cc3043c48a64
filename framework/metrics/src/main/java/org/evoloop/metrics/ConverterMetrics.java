package org.evoloop.metrics;

import io.micrometer.core.instrument.FunctionCounter;
import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.MeterRegistry;
import io.micrometer.core.instrument.MultiGauge;
import io.micrometer.core.instrument.MultiGauge.Row;
import io.micrometer.core.instrument.Tags;
import io.micrometer.core.instrument.Timer;
import io.micrometer.core.instrument.binder.MeterBinder;
import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.function.ToLongFunction;
import java.util.stream.LongStream;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.Drift;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopState;

/**
 * The metrics of a converter's status; each has the tag {@code converter}:
 *
 * <ul>
 *   <li>{@code evoloop.events} by {@code outcome}, including {@code dropped} and {@code refused}
 *   <li>{@code evoloop.queue.depth}, {@code evoloop.queue.capacity}, {@code evoloop.queue.highest}
 *   <li>{@code evoloop.conversion.time}, a timer with a histogram, of the events since {@link #bindTo}
 *   <li>{@code evoloop.failures} by {@code component}: failures since it joined the converter
 *   <li>{@code evoloop.running}, {@code evoloop.link.up}, {@code evoloop.doubt}: 1 or 0; {@code evoloop.link.up} exists
 *       only for a converter with a link
 *   <li>{@code evoloop.drift} by {@code edge}: how many of the last {@code evoloop.drift.acts} acts of the device are not in
 *       its model
 *   <li>{@code evoloop.device} and {@code evoloop.function} by {@code reading}: numeric readings of the device and of
 *       the new function, and true or false ones as 1 or 0; with their {@code unit}, such as {@code %}
 * </ul>
 *
 * <p>The values are computed when the registry is read. Components, link and readings come and go: which there are, is
 * looked up when {@code evoloop.running} is read, so that a registry shows a new one the next time; {@link #refresh} does
 * that at once.
 *
 * <p>Threading: thread-safe; reading never blocks.
 *
 * @since 0.1
 */
public final class ConverterMetrics implements MeterBinder {
    /** About 1, 2.5 and 5 of each power of ten, from the fastest loop to the order of the step limit. */
    private static final Duration[] BUCKETS = LongStream.of(
                    50,
                    100,
                    250,
                    500,
                    1_000,
                    2_500,
                    5_000,
                    10_000,
                    25_000,
                    50_000,
                    100_000,
                    250_000,
                    1_000_000,
                    5_000_000,
                    30_000_000)
            .mapToObj(micros -> Duration.of(micros, ChronoUnit.MICROS))
            .toArray(Duration[]::new);

    private final SystemEventConverter converter;
    private final Tags tags;
    private final Map<MultiGauge, Function<ConverterStatus, Map<Tags, Number>>> rows = new ConcurrentHashMap<>();

    /** @param converter a built converter */
    public ConverterMetrics(SystemEventConverter converter) {
        this.converter = converter;
        this.tags = Tags.of("converter", converter.status().name());
    }

    @Override
    public void bindTo(MeterRegistry registry) {
        events(registry, "handled", status -> status.events().handled());
        events(registry, "ignored", status -> status.events().ignored());
        events(registry, "stale", status -> status.events().stale());
        events(registry, "failed", status -> status.events().failed());
        events(registry, "dropped", status -> status.queue().dropped());
        events(registry, "refused", status -> status.queue().refused());
        gauge(
                registry,
                "evoloop.queue.depth",
                "Events that wait",
                status -> status.queue().depth());
        gauge(
                registry,
                "evoloop.queue.capacity",
                "How many events of controllers may wait",
                status -> status.queue().capacity());
        gauge(
                registry,
                "evoloop.queue.highest",
                "The most that have waited",
                status -> status.queue().highest());
        gauge(registry, "evoloop.running", "Whether events are converted", status -> {
            refresh(status);
            return truth(status.loop() == LoopState.RUNNING);
        });
        gauge(
                registry,
                "evoloop.doubt",
                "Whether the record of the device may be wrong",
                status -> truth(!status.doubt().isEmpty()));
        gauge(
                registry,
                "evoloop.drift.acts",
                "The acts of the device that evoloop.drift is about",
                status -> status.drift().acts());
        times(registry);
        rows(
                registry,
                "evoloop.drift",
                "Acts of the device that are not in its model",
                status -> drift(status.drift()));
        rows(registry, "evoloop.failures", "Failures of a component", this::failures);
        rows(registry, "evoloop.link.up", "Whether the device can be reached", this::link);
        rows(
                registry,
                "evoloop.device",
                "What is known of the device",
                status -> readings(
                        status.link() == null ? List.of() : status.link().readings()));
        rows(
                registry,
                "evoloop.function",
                "How far the new function is",
                status -> readings(status.function().readings()));
        refresh();
    }

    /** Looks up which components, link and readings there are now. */
    public void refresh() {
        refresh(converter.status());
    }

    /** What has been there before stays as it is, since a registry may be in the middle of reading it. */
    private synchronized void refresh(ConverterStatus status) {
        rows.forEach((gauge, of) -> gauge.register(
                of.apply(status).keySet().stream()
                        .<Row<?>>map(each ->
                                Row.of(each, () -> of.apply(converter.status()).getOrDefault(each, Double.NaN)))
                        .toList(),
                false));
    }

    private void times(MeterRegistry registry) {
        Timer timer = Timer.builder("evoloop.conversion.time")
                .description("From an event's observation to the start of its execution")
                .tags(tags)
                .serviceLevelObjectives(BUCKETS)
                .register(registry);
        converter.addListener(new ConverterListener() {
            @Override
            public void converted(Duration waited) {
                timer.record(waited);
            }
        });
    }

    private void rows(
            MeterRegistry registry, String name, String description, Function<ConverterStatus, Map<Tags, Number>> of) {
        rows.put(MultiGauge.builder(name).description(description).tags(tags).register(registry), of);
    }

    private static Map<Tags, Number> drift(Drift drift) {
        Map<Tags, Number> counts = new LinkedHashMap<>();
        drift.edges().forEach(edge -> counts.put(Tags.of("edge", edge.toString()), edge.count()));
        return counts;
    }

    private Map<Tags, Number> failures(ConverterStatus status) {
        Map<Tags, Number> failures = new LinkedHashMap<>();
        status.components()
                .forEach(component -> failures.put(Tags.of("component", component.name()), component.failures()));
        return failures;
    }

    private Map<Tags, Number> link(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        return link == null ? Map.of() : Map.of(Tags.empty(), truth(link.up()));
    }

    private static Map<Tags, Number> readings(List<Reading> readings) {
        Map<Tags, Number> numbers = new LinkedHashMap<>();
        for (Reading reading : readings) {
            Tags named = Tags.of("reading", reading.name(), "unit", reading.unit());
            if (reading.value() instanceof Boolean holds) {
                numbers.put(named, truth(holds));
            } else if (reading.value() instanceof Number number) {
                numbers.put(named, number);
            }
        }
        return numbers;
    }

    private static int truth(boolean holds) {
        return holds ? 1 : 0;
    }

    private void events(MeterRegistry registry, String outcome, ToLongFunction<ConverterStatus> count) {
        FunctionCounter.builder("evoloop.events", converter, asked -> count.applyAsLong(asked.status()))
                .description("Events by what became of them")
                .tags(tags.and("outcome", outcome))
                .register(registry);
    }

    private void gauge(
            MeterRegistry registry, String name, String description, ToDoubleFunction<ConverterStatus> value) {
        Gauge.builder(name, converter, asked -> value.applyAsDouble(asked.status()))
                .description(description)
                .tags(tags)
                .strongReference(true)
                .register(registry);
    }
}
