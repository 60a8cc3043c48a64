package org.evoloop.fleet.stream;

import java.util.HashMap;
import java.util.Map;
import java.util.PriorityQueue;
import org.evoloop.fleet.device.Device;
import org.jspecify.annotations.Nullable;

/**
 * Which device has something due next, and when. Most of what is due is called off or put off before its time. So a device
 * stays where it is in the queue until the time for which it was queued has come, unless something is due earlier.
 */
final class Schedule {
    private static final int FEW = 1_000;

    private final Map<String, Due> byDevice = new HashMap<>();
    private final PriorityQueue<Due> inOrder = new PriorityQueue<>(FEW, Schedule::inOrder);

    /** How many in the queue are called off. */
    private int calledOff;

    private static final class Due {
        private final String device;
        private long queuedNanos;

        /** Not before it is queued; {@link Device#NEVER} if it is called off. */
        private long atNanos;

        Due(String device, long atNanos) {
            this.device = device;
            this.queuedNanos = atNanos;
            this.atNanos = atNanos;
        }

        boolean isCalledOff() {
            return atNanos == Device.NEVER;
        }

        boolean isPutOff() {
            return atNanos > queuedNanos && !isCalledOff();
        }
    }

    private static int inOrder(Due one, Due other) {
        int byTime = Long.compare(one.queuedNanos, other.queuedNanos);
        return byTime != 0 ? byTime : one.device.compareTo(other.device);
    }

    /** @param atNanos {@link Device#NEVER} if nothing is due there */
    void set(String device, long atNanos) {
        Due due = byDevice.get(device);
        boolean stays = due != null && due.queuedNanos <= atNanos;
        if (due != null) {
            change(due, stays ? atNanos : Device.NEVER);
        }
        if (!stays && atNanos != Device.NEVER) {
            Due next = new Due(device, atNanos);
            byDevice.put(device, next);
            inOrder.add(next);
        }
        if (2 * calledOff > FEW + inOrder.size()) {
            inOrder.removeIf(Due::isCalledOff);
            byDevice.values().removeIf(Due::isCalledOff);
            calledOff = 0;
        }
    }

    private void change(Due due, long atNanos) {
        calledOff -= due.isCalledOff() ? 1 : 0;
        due.atNanos = atNanos;
        calledOff += due.isCalledOff() ? 1 : 0;
    }

    /** Removes and returns the first device at which something is due by then; null if there is none. */
    @Nullable
    String poll(long atNanos) {
        while (!inOrder.isEmpty() && inOrder.peek().queuedNanos <= atNanos) {
            Due due = inOrder.poll();
            if (due.isPutOff()) {
                due.queuedNanos = due.atNanos;
                inOrder.add(due);
                continue;
            }
            byDevice.remove(due.device, due);
            if (!due.isCalledOff()) {
                return due.device;
            }
            calledOff--;
        }
        return null;
    }

    /** The number of entries in the queue, including those called off. */
    int queued() {
        return inOrder.size();
    }
}
