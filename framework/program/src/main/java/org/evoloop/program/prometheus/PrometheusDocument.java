package org.evoloop.program.prometheus;

import io.micrometer.core.instrument.binder.jvm.JvmMemoryMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmThreadMetrics;
import io.micrometer.prometheusmetrics.PrometheusConfig;
import io.micrometer.prometheusmetrics.PrometheusMeterRegistry;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Supplier;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.metrics.ConverterMetrics;
import org.evoloop.page.Document;

/**
 * {@code /metrics} of the live page, in Prometheus text format: {@link ConverterMetrics} of each converter, and memory
 * and threads of the Java virtual machine.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class PrometheusDocument implements Document {
    /** For the service loader. */
    public PrometheusDocument() {}

    @Override
    public String path() {
        return "/metrics";
    }

    @Override
    public String mediaType() {
        return "text/plain; version=0.0.4; charset=utf-8";
    }

    @Override
    public Supplier<byte[]> of(List<SystemEventConverter> converters) {
        PrometheusMeterRegistry registry = new PrometheusMeterRegistry(PrometheusConfig.DEFAULT);
        List<ConverterMetrics> metrics =
                converters.stream().map(ConverterMetrics::new).toList();
        metrics.forEach(each -> each.bindTo(registry));
        new JvmMemoryMetrics().bindTo(registry);
        new JvmThreadMetrics().bindTo(registry);
        return () -> {
            metrics.forEach(ConverterMetrics::refresh);
            return registry.scrape().getBytes(StandardCharsets.UTF_8);
        };
    }
}
