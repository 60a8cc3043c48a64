package org.evoloop.http;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import org.evoloop.LightBulb;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;

/** The light bulb's converter with the test's own monitor and execute component. */
final class Lamp implements AutoCloseable {
    static final Duration PATIENCE = Duration.ofSeconds(20);

    private final SystemClock clock = new SystemClock();
    final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));

    Lamp(EventMonitor monitor, EventExecute execute) {
        converter.addMonitor(monitor);
        converter.addExecute(execute);
        converter.addKnowledge(LightBulb.withoutTimeout());
        converter.build();
        converter.start();
    }

    void awaitState(String original) {
        await().atMost(PATIENCE)
                .untilAsserted(
                        () -> assertThat(converter.status().states().original().name())
                                .isEqualTo(original));
    }

    void awaitHistory(String detail) {
        await().atMost(PATIENCE)
                .untilAsserted(() -> assertThat(converter.history())
                        .anyMatch(entry -> entry.detail().contains(detail)));
    }

    @Override
    public void close() {
        converter.close();
        clock.close();
    }
}
