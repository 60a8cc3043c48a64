package org.evoloop.loop;

import java.util.Locale;
import org.evoloop.time.OwnedThread;
import org.jspecify.annotations.Nullable;

/**
 * Assigns threads to components, and replaces a thread that hangs.
 *
 * <p>Threading: read from any thread; changed under the loop's lock.
 */
final class Crew {
    private final LoopConfig config;
    private int carriers;
    private volatile @Nullable CarrierThread shared;

    Crew(LoopConfig config) {
        this.config = config;
        if (config.threading() == ThreadingModel.SINGLE_CARRIER) {
            shared = nextShared();
        }
    }

    private CarrierThread nextShared() {
        carriers++;
        return new CarrierThread(
                this, threadName(config, "carrier") + (carriers == 1 ? "" : "-" + carriers), config.waiting());
    }

    private static String threadName(LoopConfig config, String rest) {
        return "mapek-" + config.name() + "-" + rest;
    }

    /** The name of the thread of {@code component}, if it has one of its own. */
    static String threadName(LoopConfig config, Component component) {
        return threadName(config, component.role().name().toLowerCase(Locale.ROOT) + "-" + component.name());
    }

    /** A thread for {@code component} alone; null if it shares one, or there are none. */
    @Nullable
    CarrierThread own(Component component) {
        return config.threading() == ThreadingModel.THREAD_PER_COMPONENT
                ? new CarrierThread(this, threadName(config, component), config.waiting())
                : null;
    }

    /** The thread shared by all components without one of their own; null if there is none. */
    @Nullable
    CarrierThread shared() {
        return shared;
    }

    /** Whether the caller's thread calls components, or did so until its component was given up or removed. */
    boolean ownsCurrentThread() {
        return OwnedThread.isCurrentOf(this);
    }

    void start() {
        CarrierThread carrier = shared;
        if (carrier != null) {
            carrier.start();
        }
    }

    /**
     * Interrupts a thread whose work was given up. A shared thread is replaced, and ends when the component in which it
     * hangs returns.
     */
    void giveUp(CarrierThread late) {
        if (late == shared) {
            CarrierThread successor = nextShared();
            successor.start();
            shared = successor;
            late.retire();
        } else {
            late.interrupt();
        }
    }

    void retire() {
        CarrierThread carrier = shared;
        if (carrier != null) {
            carrier.retire();
        }
    }
}
