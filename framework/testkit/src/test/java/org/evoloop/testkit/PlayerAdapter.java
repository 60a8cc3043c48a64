package org.evoloop.testkit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.evolution.Step;

/** Adapters of the player: a correct one and some faulty ones. */
final class PlayerAdapter {
    enum Kind {
        IN_ORDER,
        /** Reports the effect of a command as soon as it is written. */
        EFFECTS_TOO_SOON,
        /** Delays what the device does by itself until it has reported the next effect. */
        FACTS_TOO_LATE,
        /** Does not report the effects of commands. */
        NO_EFFECTS,
        /** Does not report what the device does by itself. */
        NO_FACTS
    }

    private final Kind kind;
    private final DeviceLine line;
    private final Buttons buttons = new Buttons();
    private final Sender sender = new Sender();
    private final List<String> held = new ArrayList<>();
    private volatile CountDownLatch taken = new CountDownLatch(0);

    private PlayerAdapter(Kind kind, DeviceLine line) {
        this.kind = kind;
        this.line = line;
        line.listen(this::read);
    }

    static DeviceAdapter of(Kind kind, DeviceLine line) {
        PlayerAdapter adapter = new PlayerAdapter(kind, line);
        return new DeviceAdapter(adapter.buttons, adapter.sender);
    }

    /** Called on the line's thread. */
    private void read(DeviceReport report) {
        if (report instanceof DeviceReport.Acted) {
            held.add(report.event());
            if (kind != Kind.FACTS_TOO_LATE || taken.getCount() == 0) {
                reportHeld();
            }
            return;
        }
        if (kind != Kind.NO_EFFECTS) {
            sender.took();
        }
        reportHeld();
        taken.countDown();
    }

    private void reportHeld() {
        if (kind != Kind.NO_FACTS) {
            held.forEach(buttons::acted);
        }
        held.clear();
    }

    private static final class Buttons extends PushMonitor {
        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("play", "pause", "stop");
        }

        void acted(String event) {
            push(fromPanel(event, true));
        }
    }

    private final class Sender extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("play", "pause", "stop");
        }

        @Override
        protected void send(Step step) throws Exception {
            CountDownLatch answer = new CountDownLatch(1);
            taken = answer;
            line.command(step.trigger().name());
            if (kind == Kind.EFFECTS_TOO_SOON) {
                tookEffect();
            } else if (!answer.await(20, TimeUnit.SECONDS)) {
                throw new TimeoutException("no answer to " + step.trigger());
            }
        }

        void took() {
            tookEffect();
        }
    }
}
