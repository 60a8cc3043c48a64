package org.evoloop.benchmarks.running;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.function.Visit;
import org.evoloop.journal.Journal;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * A converter for the paper's cleaning robot whose device costs nothing, so that only the converter is measured.
 *
 * <p>Threading: one thread drives it.
 */
final class CleaningRobot implements AutoCloseable {
    /** Switched on once; then it repeats a round with every kind of decision that can be executed. */
    static final List<String> STORY =
            List.of("Clean", "Clean", "Clean", "Clean", "endSpot", "Spot", "arriveSpot", "endSpot");

    private final PathTimer timer;
    private final boolean threads;
    private final SystemClock clock = new SystemClock();
    private final SystemEventConverter converter;
    private final Panel panel = new Panel();
    private final Signal wanted = new Signal();
    private final Signal converted = new Signal();

    CleaningRobot(PathTimer timer, boolean threads) {
        this(timer, threads, null);
    }

    /** @param journal null for none */
    CleaningRobot(PathTimer timer, boolean threads, @Nullable Journal journal) {
        this.timer = timer;
        this.threads = threads;
        LoopConfig config = LoopConfig.defaults("robot", clock);
        converter = new SystemEventConverter(threads ? config : config.withoutThreads());
        converter.addMonitor(panel);
        converter.addExecute(new Device());
        converter.addKnowledge(new Knowledge());
        if (journal != null) {
            converter.journal(journal);
        }
        converter.build();
        converter.start();
    }

    /** Makes the monitor report the next event of the story, and waits until it is converted. */
    void next() throws InterruptedException {
        if (threads) {
            converted.clear();
            wanted.set();
            converted.await();
        } else {
            converter.observe(panel);
            converter.step();
        }
    }

    SystemEventConverter converter() {
        return converter;
    }

    Configuration states() {
        return converter.knowledge().configuration();
    }

    /** @throws IllegalStateException if any event was not handled, since its time would be meaningless */
    void requireAllHandled() {
        ConverterStatus status = converter.status();
        ConverterStatus.EventCounts events = status.events();
        if (events.ignored() + events.stale() + events.failed() + status.queue().dropped() > 0) {
            throw new IllegalStateException("not every event was handled: " + status);
        }
    }

    @Override
    public void close() {
        converter.close();
        clock.close();
    }

    private final class Panel extends EventMonitor {
        private int position;

        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("endSpot");
        }

        @Override
        protected Occurrence getEvent() throws InterruptedException {
            if (threads) {
                wanted.await();
            }
            String event = STORY.get(position);
            position = position + 1 == STORY.size() ? 1 : position + 1;
            Occurrence occurrence = event.equals("endSpot") ? fromDevice(event) : fromController(event);
            timer.start();
            return occurrence;
        }
    }

    private final class Device extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("Clean", "Spot");
        }

        @Override
        protected void awaitReady(Step step) {
            timer.stop();
        }

        @Override
        protected void send(Step step) {}

        /** The first callback for an event that sends nothing, the last one for any other event. */
        @Override
        protected void settled(Configuration now) {
            timer.stop();
            if (!converter.knowledge().models().isNew(now.evolved())) {
                converted.set();
            }
        }
    }

    /** Its functions run only briefly and signal their end, so that their start does not delay the next event. */
    private final class Knowledge extends StateKnowledge {
        // Far longer than the story's steps, so that this timer is started and cancelled each time.
        private static final Duration LONG = Duration.ofHours(1);

        Knowledge() {
            super(PaperModels.cleaningRobot());
        }

        @Override
        protected void registerNewFunctions() {
            function("Move", visit -> converted.set());
            function("SpotWait", this::spotWait);
        }

        private void spotWait(Visit visit) {
            visit.finishAfter(LONG, "timeout");
            converted.set();
        }
    }
}
