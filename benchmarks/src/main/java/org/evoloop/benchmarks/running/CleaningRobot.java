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
 * A converter for the paper's cleaning robot whose device costs nothing, so that what is left is the converter.
 *
 * <p>Threading: one thread drives it.
 */
final class CleaningRobot implements AutoCloseable {
    /** Switched on once; then round after round, through every kind of decision that can be carried out. */
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

    /** @param journal null if it keeps none */
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

    /** Has the monitor tell the next event of the story, and waits until it is converted. */
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

    /** @throws IllegalStateException if any event came to no good end: its time would mean nothing */
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

        /** The first call for an event that has nothing to send, the last for any other. */
        @Override
        protected void settled(Configuration now) {
            timer.stop();
            if (!converter.knowledge().models().isNew(now.evolved())) {
                converted.set();
            }
        }
    }

    /** Its functions run for a moment only; they say when, so that their start does not delay the next event. */
    private final class Knowledge extends StateKnowledge {
        // The story goes on long before, so that this timer is started and called off each time.
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
