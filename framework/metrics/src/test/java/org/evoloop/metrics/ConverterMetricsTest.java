package org.evoloop.metrics;

import static org.assertj.core.api.Assertions.assertThat;

import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.simple.SimpleMeterRegistry;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.LightBulb;
import org.evoloop.PaperModels;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;
import org.evoloop.function.Reading;
import org.evoloop.testkit.ConverterHarness;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What a registry of the user's own shows, which nobody tells to refresh. */
class ConverterMetricsTest {
    private final SimpleMeterRegistry registry = new SimpleMeterRegistry();
    private final ConverterHarness lamp = ConverterHarness.of(new LightBulb(
                    PaperModels.lightBulb(),
                    Duration.ofSeconds(2),
                    visit -> visit.progress("warming up", List.of(Reading.of("warmth", 0.5, "")))))
            .with(new Broken())
            .start();

    /** Fails on the second step. */
    private static final class Broken extends EventExecute {
        private int steps;

        Broken() {
            super("Lamp");
        }

        @Override
        protected Set<String> sendableEvents() {
            return Set.of("switch");
        }

        @Override
        protected void send(Step step) {
            if (++steps == 2) {
                throw new IllegalStateException("the bulb is loose");
            }
        }
    }

    @AfterEach
    void close() {
        lamp.close();
    }

    private double value(String name, String... tags) {
        Gauge gauge = registry.find(name).tags(tags).gauge();
        return gauge == null ? Double.NaN : gauge.value();
    }

    @Test
    void failuresAreCountedAsTheyHappen() {
        new ConverterMetrics(lamp.converter()).bindTo(registry);
        assertThat(value("evoloop.failures", "component", "Lamp")).isZero();
        lamp.press("switch").press("switch").press("switch").press("switch");
        assertThat(value("evoloop.failures", "component", "Lamp")).isEqualTo(1);
    }

    @Test
    void whatTheModelOfTheDeviceDoesNotHaveIsCounted() {
        new ConverterMetrics(lamp.converter()).bindTo(registry);
        lamp.press("switch").advance(Duration.ofMinutes(1)).found("off");
        value("evoloop.running");
        assertThat(value("evoloop.drift", "edge", "on --?--> off")).isEqualTo(1);
        assertThat(value("evoloop.drift.acts")).isEqualTo(2);
    }

    @Test
    void aReadingThatComesIsThereTheNextTime() {
        new ConverterMetrics(lamp.converter()).bindTo(registry);
        lamp.press("switch").press("switch").press("switch").press("switch");
        value("evoloop.running");
        assertThat(value("evoloop.function", "reading", "warmth")).isEqualTo(0.5);
    }
}
