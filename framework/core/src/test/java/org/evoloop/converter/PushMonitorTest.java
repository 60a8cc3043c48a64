package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.evolution.EventNames;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Plan;
import org.evoloop.statemachine.Event;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What is pushed reaches the loop in order, whichever thread delivers it. */
@Timeout(60)
class PushMonitorTest {
    private static final int EVENTS = 2_000;
    private static final List<String> IN_ORDER =
            IntStream.range(0, EVENTS).mapToObj(number -> "e" + number).toList();

    private final ManualClock clock = new ManualClock();
    private final BlockingQueue<String> handled = new LinkedBlockingQueue<>();
    private final PushMonitor monitor = new PushMonitor("Panel");

    @Test
    void whatOneThreadPressesStaysInOrder() throws Exception {
        try (MapeLoop<Occurrence, Occurrence, Occurrence> loop = built()) {
            loop.start();
            IN_ORDER.forEach(monitor::press);
            assertThat(takeAll()).isEqualTo(IN_ORDER);
        }
    }

    private List<String> takeAll() throws InterruptedException {
        List<String> taken = new ArrayList<>();
        while (taken.size() < EVENTS) {
            String next = handled.poll(10, TimeUnit.SECONDS);
            assertThat(next).as("after %s", taken).isNotNull();
            taken.add(next);
        }
        return taken;
    }

    private MapeLoop<Occurrence, Occurrence, Occurrence> built() {
        LoopConfig config = LoopConfig.defaults("pushed", clock).withQueueCapacity(EVENTS);
        MapeLoop<Occurrence, Occurrence, Occurrence> loop = new MapeLoop<>(config, new Strict());
        EventNames names = new EventNames(IN_ORDER.stream().map(Event::new).collect(Collectors.toSet()));
        Friends.MONITOR
                .of(monitor)
                .attach(config, loop, names, (event, values) -> Set.of(), event -> false, (occurrence, then) -> {});
        loop.addMonitor(monitor);
        loop.addAnalyze(new Analyze<>("Analyze") {
            @Override
            protected Occurrence analyze(Occurrence occurrence) {
                return occurrence;
            }
        });
        loop.addPlan(new Plan<>("Plan") {
            @Override
            protected Occurrence plan(Occurrence occurrence) {
                return occurrence;
            }
        });
        loop.addExecute(new Execute<>("Execute") {
            @Override
            protected void execute(Occurrence occurrence) {
                handled.add(occurrence.label());
            }
        });
        loop.build();
        return loop;
    }

    private static final class Strict implements LoopListener<Occurrence> {
        @Override
        public void failed(Failure<Occurrence> failure) {
            throw new AssertionError(failure.toString());
        }

        @Override
        public void dropped(Occurrence occurrence, boolean first) {
            throw new AssertionError(occurrence + " was dropped");
        }
    }

    @Test
    void lossOfTheOldestReportsBeforeTheConverterIsBuiltIsLogged() {
        try (LoggedLines log = new LoggedLines(SystemEventConverter.class.getName())) {
            for (int event = 0; event < 1_024; event++) {
                monitor.push(monitor.fromDevice("e" + event));
            }
            assertThat(log.lines()).noneMatch(line -> line.startsWith("Panel"));
            monitor.push(monitor.fromDevice("e1024"));
            monitor.push(monitor.fromDevice("e1025"));
            // Converters of earlier tests may still have something to say.
            assertThat(log.lines())
                    .filteredOn(line -> line.startsWith("Panel"))
                    .containsExactly(
                            "Panel reports more than 1024 events before its converter is built; the oldest are lost");
        }
    }
}
