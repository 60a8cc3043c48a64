package org.evoloop.converter;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * A converter as the device of another. What becomes of the events that it is sent, and where it goes by itself, is reported
 * by its listener: in the order in which it happened there.
 *
 * <p>Threading: as its superclasses.
 */
final class LowerConverter extends EventExecute implements ConverterListener {
    private static final int ANSWER_SECONDS = 20;

    private final ConverterDelegate lower;
    private final Reports reports;
    private final BlockingQueue<HistoryEntry> answers = new LinkedBlockingQueue<>();
    private volatile @Nullable Occurrence asked;

    /** @param lower built */
    LowerConverter(ConverterDelegate lower) {
        super(lower.status().name());
        this.lower = lower;
        this.reports = new Reports(lower.status().name() + "Reports");
        lower.addListener(this);
    }

    /** Tells the upper converter where the lower one went by itself. */
    private static final class Reports extends PushMonitor {
        Reports(String name) {
            super(name);
        }

        void found(State state) {
            push(foundIn(state.name()));
        }
    }

    EventMonitor reports() {
        return reports;
    }

    @Override
    protected Set<String> sendableEvents() {
        return lower.controllerEvents().stream().map(Event::name).collect(Collectors.toUnmodifiableSet());
    }

    @Override
    protected void send(Step step) throws Exception {
        Occurrence event = new Occurrence.Heard(
                step.trigger(),
                values(),
                Source.CONTROLLER,
                Occurrence.ANY_VISIT,
                lower.clock().nanoTime());
        answers.clear();
        asked = event;
        if (!lower.offer(event)) {
            throw new IllegalStateException(name() + " does not take " + step.trigger() + "; is it started?");
        }
        HistoryEntry answer = answer();
        if (answer == null) {
            throw new UnknownEffectException(name() + " has not dealt with " + step.trigger());
        }
        if (!hasObeyed(answer)) {
            throw new IllegalStateException(name() + " did not obey: " + answer.detail());
        }
    }

    private @Nullable HistoryEntry answer() throws InterruptedException {
        if (lower.hasThreads()) {
            return answers.poll(ANSWER_SECONDS, TimeUnit.SECONDS);
        }
        while (answers.isEmpty() && lower.step()) {}
        return answers.poll();
    }

    @Override
    public void ended(HistoryEntry entry) {
        if (!entry.occurrence().equals(asked)) {
            if (hasMoved(entry)) {
                reports.found(entry.after().evolved());
            }
            return;
        }
        if (hasObeyed(entry)) {
            tookEffect();
        }
        answers.add(entry);
    }

    private static boolean hasObeyed(HistoryEntry entry) {
        return entry.outcome() == Outcome.HANDLED || hasMoved(entry);
    }

    private static boolean hasMoved(HistoryEntry entry) {
        return !entry.before().evolved().equals(entry.after().evolved());
    }

    @Override
    protected Optional<String> locate() {
        return Optional.of(lower.knowledge().getCurrentState().name());
    }
}
