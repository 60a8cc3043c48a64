package org.evoloop.fleet.stream;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.PriorityQueue;
import org.evoloop.fleet.device.Device;
import org.jspecify.annotations.Nullable;

/**
 * Which device is to be looked at next, and when. Most of what is due is called off before: that is only crossed out, and
 * taken from the queue when its time has come, or when most of the queue is crossed out.
 */
final class Schedule {
    private static final int FEW = 1_000;

    private final Map<String, Due> byDevice = new HashMap<>();
    private final PriorityQueue<Due> inOrder = new PriorityQueue<>(
            Comparator.<Due>comparingLong(due -> due.atNanos).thenComparing(due -> due.device));

    private static final class Due {
        private final long atNanos;
        private final String device;
        private boolean off;

        Due(long atNanos, String device) {
            this.atNanos = atNanos;
            this.device = device;
        }
    }

    /** @param atNanos {@link Device#NEVER} if nothing is due there */
    void set(String device, long atNanos) {
        Due before = byDevice.get(device);
        if (before != null && before.atNanos == atNanos) {
            return;
        } else if (before != null) {
            before.off = true;
        }
        if (atNanos != Device.NEVER) {
            Due due = new Due(atNanos, device);
            byDevice.put(device, due);
            inOrder.add(due);
        } else if (before != null) {
            byDevice.remove(device);
        }
        if (inOrder.size() > FEW + 2 * byDevice.size()) {
            inOrder.removeIf(due -> due.off);
        }
    }

    /** Removes and returns the first device at which something is due by then; null if there is none. */
    @Nullable
    String poll(long atNanos) {
        while (!inOrder.isEmpty() && inOrder.peek().atNanos <= atNanos) {
            Due due = inOrder.poll();
            if (!due.off) {
                byDevice.remove(due.device);
                return due.device;
            }
        }
        return null;
    }

    /** How much is queued, crossed out or not. */
    int queued() {
        return inOrder.size();
    }
}
