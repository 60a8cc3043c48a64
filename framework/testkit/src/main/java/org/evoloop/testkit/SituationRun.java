package org.evoloop.testkit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.SystemClock;

/** Runs one situation with an adapter and a running converter. */
final class SituationRun implements AutoCloseable {
    private final Object lock = new Object();
    private final SystemClock clock = new SystemClock();
    private final DeviceModel device;
    private final Set<String> own;
    private final Duration patience;
    private final DeviceLine line;
    private final DeviceAdapter adapter;
    private final TestMonitor controller = new TestMonitor();
    private final SystemEventConverter converter;
    private final List<HistoryEntry> ended = new ArrayList<>();
    private final List<String> doubts = new ArrayList<>();
    private int presses;

    SituationRun(StateMachine model, Set<String> own, Duration patience, Function<DeviceLine, DeviceAdapter> adapters) {
        this.device = new DeviceModel(model);
        this.own = own;
        this.patience = patience;
        this.line = new DeviceLine(device, () -> change(() -> {}));
        this.adapter = adapters.apply(line);
        this.converter = new SystemEventConverter(LoopConfig.defaults("order", clock));
        if (!line.isHeard()) {
            close();
            throw new IllegalStateException("the adapter does not listen to its line; call line.listen");
        }
        converter.addMonitor(controller);
        converter.addMonitor(adapter.monitor());
        converter.addExecute(adapter.execute());
        converter.addKnowledge(new StateKnowledge(new ModelPair(model, model.withName("the same"))));
        converter.addListener(new Books());
        try {
            converter.build();
        } catch (RuntimeException refused) {
            close();
            throw refused;
        }
        converter.start();
    }

    private final class Books implements ConverterListener {
        @Override
        public void ended(HistoryEntry entry) {
            change(() -> ended.add(entry));
        }

        @Override
        public void doubted(String why) {
            change(() -> {
                if (!why.isEmpty()) {
                    doubts.add(why);
                }
            });
        }
    }

    private void change(Runnable what) {
        synchronized (lock) {
            what.run();
            lock.notifyAll();
        }
    }

    void play(Situation situation) {
        for (String event : situation.way()) {
            if (own.contains(event)) {
                line.act(event);
            } else {
                press(event);
            }
            requireAgreement("on the way to where it matters, after " + event);
        }
        line.meets(situation);
        press(situation.command());
        requireAgreement(situation.toString());
    }

    private void press(String event) {
        presses++;
        controller.press(event);
    }

    private void requireAgreement(String when) {
        boolean agreed = awaitAgreement();
        synchronized (lock) {
            if (!agreed || !doubts.isEmpty()) {
                throw new AssertionError("the adapter does not keep the order " + when + ": " + what()
                        + "\n  Report both what the device does by itself and that a step took effect (tookEffect) "
                        + "on the thread that reads from the device, in the order in which the device says so.\n  It "
                        + "has reported:" + outcomes());
            }
        }
    }

    private String what() {
        if (!doubts.isEmpty()) {
            return doubts.get(0);
        }
        return knowsTheTruth()
                ? "of " + line.acts() + " things that the device did by itself it has reported "
                        + facts(Occurrence.Heard.class) + " within " + patience
                : "the device is in " + device.state() + ", and the converter takes it to be in "
                        + converter.knowledge().getOriginalState();
    }

    private String outcomes() {
        return ended.stream()
                .map(entry -> "\n    " + entry.occurrence() + ": " + entry.outcome() + ", device "
                        + entry.before().original() + " -> " + entry.after().original())
                .collect(Collectors.joining());
    }

    private boolean knowsTheTruth() {
        return converter.knowledge().getOriginalState().equals(device.state());
    }

    /** An adapter that reports the state in which it found the device need not report how the device got there. */
    private boolean hasReportedAll() {
        return line.isQuiet()
                && count(Source.CONTROLLER) == presses
                && (facts(Occurrence.Heard.class) == line.acts() || facts(Occurrence.Found.class) > 0);
    }

    private long count(Source source) {
        return ended.stream()
                .filter(entry -> entry.occurrence().source() == source)
                .count();
    }

    private long facts(Class<? extends Occurrence> kind) {
        return ended.stream()
                .filter(entry -> kind.isInstance(entry.occurrence())
                        && entry.occurrence().isFact())
                .count();
    }

    /**
     * Waits until all reports have come and the record is right. Gives up after a doubt, or when the record is wrong after
     * all reports, since neither changes any more.
     */
    private boolean awaitAgreement() {
        long deadline = clock.nanoTime() + patience.toNanos();
        synchronized (lock) {
            while (true) {
                // Read before the record: the last report may come between the two.
                boolean complete = hasReportedAll();
                boolean right = knowsTheTruth();
                long left = deadline - clock.nanoTime();
                if ((complete && right) || !doubts.isEmpty()) {
                    return doubts.isEmpty();
                }
                if (left <= 0 || (complete && facts(Occurrence.Heard.class) == line.acts())) {
                    return false;
                }
                try {
                    TimeUnit.NANOSECONDS.timedWait(lock, left);
                } catch (InterruptedException stop) {
                    Thread.currentThread().interrupt();
                    return false;
                }
            }
        }
    }

    @Override
    public void close() {
        converter.close();
        line.close();
        adapter.close().run();
        clock.close();
    }
}
