package org.evoloop.fleet.stream;

import java.util.HashMap;
import java.util.Map;
import java.util.PriorityQueue;
import org.evoloop.fleet.device.Device;
import org.jspecify.annotations.Nullable;

/**
 * Which device has something due next, and when. Most entries are cancelled before they are due: they are only marked, and
 * removed from the queue when their time has come, or when most of the queue is cancelled.
 */
final class Schedule {
    private static final int FEW = 1_000;

    private final Map<String, Due> byDevice = new HashMap<>();
    private final PriorityQueue<Due> inOrder = new PriorityQueue<>(FEW, Schedule::inOrder);

    private static final class Due {
        private final long atNanos;
        private final String device;
        private boolean cancelled;

        Due(long atNanos, String device) {
            this.atNanos = atNanos;
            this.device = device;
        }
    }

    private static int inOrder(Due one, Due other) {
        int byTime = Long.compare(one.atNanos, other.atNanos);
        return byTime != 0 ? byTime : one.device.compareTo(other.device);
    }

    /** @param atNanos {@link Device#NEVER} if nothing is due there */
    void set(String device, long atNanos) {
        if (atNanos == Device.NEVER) {
            cancel(byDevice.remove(device));
        } else {
            Due due = new Due(atNanos, device);
            cancel(byDevice.put(device, due));
            inOrder.add(due);
        }
        if (inOrder.size() > FEW + 2 * byDevice.size()) {
            inOrder.removeIf(due -> due.cancelled);
        }
    }

    private static void cancel(@Nullable Due due) {
        if (due != null) {
            due.cancelled = true;
        }
    }

    /** Removes and returns the first device at which something is due by then; null if there is none. */
    @Nullable
    String poll(long atNanos) {
        while (!inOrder.isEmpty() && inOrder.peek().atNanos <= atNanos) {
            Due due = inOrder.poll();
            if (!due.cancelled) {
                byDevice.remove(due.device);
                return due.device;
            }
        }
        return null;
    }

    /** The number of entries in the queue, cancelled ones included. */
    int queued() {
        return inOrder.size();
    }
}
