package org.evoloop.testkit;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * The cable to a device that an {@link OrderCheck} simulates: commands go one way, reports come the other, in order. An
 * adapter that uses bytes adds its own encoding.
 *
 * <p>Reports are slow: they come when the thread that sent the command waits for something, or has continued. Then they
 * come one right after another.
 *
 * <p>Threading: thread-safe; reports come on a thread of the line, one at a time.
 *
 * @since 0.1
 */
public final class DeviceLine {
    private static final int MOST_LOOKS = 500;
    private static final long LOOK_NANOS = 1_000_000;

    private final DeviceModel device;
    private final Runnable changed;
    private final BlockingQueue<Delivery> deliveries = new LinkedBlockingQueue<>();
    private final Thread carrier = new Thread(this::carry, "device-line");
    private volatile @Nullable Consumer<DeviceReport> reader;
    private @Nullable Situation next;
    private int undelivered;
    private int acts;

    private record Delivery(@Nullable Thread sender, List<DeviceReport> reports) {}

    /** @param changed called after each delivery */
    DeviceLine(DeviceModel device, Runnable changed) {
        this.device = device;
        this.changed = changed;
        carrier.setDaemon(true);
        carrier.start();
    }

    /** Sets the receiver of the device's reports; once, before the converter is started. */
    public void listen(Consumer<DeviceReport> newReader) {
        reader = newReader;
    }

    /**
     * Sends the command {@code event} to the device, and returns once it is sent: its effect is not known yet.
     */
    public synchronized void command(String event) {
        List<DeviceReport> reports = new ArrayList<>();
        Situation now = next;
        boolean meant = now != null && now.command().equals(event);
        if (now != null && meant && now.before()) {
            act(now.own(), reports);
        }
        device.take(event);
        reports.add(new DeviceReport.Took(event, device.state().name()));
        if (now != null && meant && !now.before()) {
            act(now.own(), reports);
        }
        next = meant ? null : now;
        send(new Delivery(Thread.currentThread(), reports));
    }

    private void act(String event, List<DeviceReport> reports) {
        if (!device.take(event)) {
            throw new IllegalStateException("the device, in " + device.state() + ", does not know " + event);
        }
        acts++;
        reports.add(new DeviceReport.Acted(event, device.state().name()));
    }

    private void send(Delivery delivery) {
        undelivered++;
        deliveries.add(delivery);
    }

    /** The device acts by itself while no command is being sent. */
    synchronized void act(String event) {
        List<DeviceReport> reports = new ArrayList<>();
        act(event, reports);
        send(new Delivery(null, reports));
    }

    /** Sets what happens during the next command of that event. */
    synchronized void meets(Situation situation) {
        next = situation;
    }

    synchronized boolean isQuiet() {
        return undelivered == 0;
    }

    synchronized int acts() {
        return acts;
    }

    boolean isHeard() {
        return reader != null;
    }

    private void carry() {
        try {
            while (true) {
                Delivery delivery = deliveries.take();
                awaitRest(delivery.sender());
                Consumer<DeviceReport> listening = reader;
                if (listening != null) {
                    delivery.reports().forEach(listening);
                }
                synchronized (this) {
                    undelivered--;
                }
                changed.run();
            }
        } catch (InterruptedException closed) {
            Thread.currentThread().interrupt();
        }
    }

    /** Waits until the sender of a command waits; a sender that reports the effect before that cannot know it. */
    private static void awaitRest(@Nullable Thread sender) throws InterruptedException {
        int atRest = 0;
        for (int look = 0; sender != null && atRest < 2 && look < MOST_LOOKS; look++) {
            LockSupport.parkNanos(LOOK_NANOS);
            if (Thread.interrupted()) {
                throw new InterruptedException();
            }
            Thread.State state = sender.getState();
            atRest = state == Thread.State.RUNNABLE || state == Thread.State.BLOCKED ? 0 : atRest + 1;
        }
    }

    void close() {
        carrier.interrupt();
    }
}
