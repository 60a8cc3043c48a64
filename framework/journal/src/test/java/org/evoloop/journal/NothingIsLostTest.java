package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A flood from eight monitors while components are exchanged: each event has an outcome, and the journal says the same.
 */
class NothingIsLostTest {
    private static final int MONITORS = 8;

    /** Mostly events that may be lost in a full queue; also facts, and events that no model has. */
    private static final List<String> STORY =
            List.of("Clean", "Spot", "Clean!", "arriveSpot", "endSpot!", "Claen!", "Clean");

    private final AtomicLong left = new AtomicLong();
    private final AtomicLong reported = new AtomicLong();
    private final CountDownLatch allReported = new CountDownLatch(1);
    private final SystemClock clock = new SystemClock();

    @TempDir
    private Path directory;

    private final class Reporter extends EventMonitor {
        private final CountDownLatch never = new CountDownLatch(1);

        Reporter(String name) {
            super(name);
        }

        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("Clean", "endSpot");
        }

        @Override
        protected @Nullable Occurrence getEvent() throws InterruptedException {
            long number = left.getAndDecrement();
            if (number <= 0) {
                allReported.countDown();
                never.await();
            }
            reported.incrementAndGet();
            String event = STORY.get((int) (number % STORY.size()));
            return event.endsWith("!") ? fromDevice(event.substring(0, event.length() - 1)) : fromController(event);
        }
    }

    private static final class Driver extends EventExecute {
        Driver(String name) {
            super(name);
        }

        @Override
        protected Set<String> sendableEvents() {
            return Set.of("Clean", "Spot");
        }

        @Override
        protected void send(Step step) {}
    }

    private SystemEventConverter converter() {
        SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("flooded", clock));
        for (int number = 0; number < MONITORS; number++) {
            converter.addMonitor(new Reporter("Teller" + number));
        }
        converter.addExecute(new Driver("Driver"));
        converter.addKnowledge(new StateKnowledge(Robot.MODELS) {
            @Override
            protected void registerNewFunctions() {
                function("SpotWait", NewFunction.none());
                function("Move", NewFunction.none());
                effect("beep", () -> {});
            }
        });
        converter.journal(Journal.in(directory).withKeptBytes(1 << 30));
        converter.build();
        return converter;
    }

    @Test
    @Timeout(120)
    void ofFiftyThousandEvents() throws InterruptedException {
        flood(50_000);
    }

    @Test
    @Timeout(600)
    @Tag("slow")
    void ofAMillionEvents() throws InterruptedException {
        flood(1_000_000);
    }

    private void flood(long events) throws InterruptedException {
        ConverterStatus last;
        try (SystemEventConverter converter = converter()) {
            left.set(events);
            converter.start();
            List<String> names = new ArrayList<>();
            for (int number = 0; number < MONITORS; number++) {
                names.add("Teller" + number);
            }
            for (int change = 0; allReported.getCount() > 0; change++) {
                String name = names.get(change % MONITORS);
                converter.exchange(name, new Reporter(name));
                converter.exchange("Driver", new Driver("Driver"));
            }
            converter.close();
            last = converter.status();
        }
        assertThat(sum(last)).isGreaterThanOrEqualTo(reported.get());
        // The rest are the core's own requests for the device's state, after a doubt or after facts for which there was
        // no room.
        assertThat(sum(last) - reported.get()).isLessThan(events / 100);

        left.set(0);
        try (SystemEventConverter next = converter()) {
            ConverterStatus recovered = next.status();
            assertThat(recovered.events())
                    .usingRecursiveComparison()
                    .comparingOnlyFields("handled", "ignored", "stale", "failed")
                    .isEqualTo(last.events());
            assertThat(recovered.queue().dropped()).isEqualTo(last.queue().dropped());
            assertThat(recovered.queue().refused()).isEqualTo(last.queue().refused());
            // In doubt, the device is asked once more, if that does not already wait.
            assertThat(sum(recovered))
                    .isBetween(sum(last), sum(last) + (last.doubt().isEmpty() ? 0 : 1));
        }
        clock.close();
    }

    /** Everything that has an outcome or waits for one. */
    private static long sum(ConverterStatus status) {
        ConverterStatus.EventCounts events = status.events();
        return events.handled()
                + events.ignored()
                + events.stale()
                + events.failed()
                + status.queue().dropped()
                + status.queue().refused()
                + status.queue().depth();
    }
}
