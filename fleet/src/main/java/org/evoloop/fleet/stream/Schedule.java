package org.evoloop.fleet.stream;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeSet;
import org.evoloop.fleet.device.Device;
import org.jspecify.annotations.Nullable;

/** The times at which something is due, by device. */
final class Schedule {
    private final Map<String, Due> byDevice = new HashMap<>();
    private final TreeSet<Due> inOrder =
            new TreeSet<>(Comparator.comparingLong(Due::atNanos).thenComparing(Due::device));

    private record Due(long atNanos, String device) {}

    /** @param atNanos {@link Device#NEVER} if nothing is due there */
    void set(String device, long atNanos) {
        Due before = byDevice.get(device);
        if (before != null && before.atNanos == atNanos) {
            return;
        } else if (before != null) {
            inOrder.remove(before);
            byDevice.remove(device);
        }
        if (atNanos != Device.NEVER) {
            Due due = new Due(atNanos, device);
            byDevice.put(device, due);
            inOrder.add(due);
        }
    }

    /** Removes and returns the first device at which something is due by then; null if there is none. */
    @Nullable
    String poll(long atNanos) {
        if (inOrder.isEmpty() || inOrder.first().atNanos > atNanos) {
            return null;
        }
        Due due = inOrder.pollFirst();
        byDevice.remove(due.device);
        return due.device;
    }

    void clear() {
        byDevice.clear();
        inOrder.clear();
    }
}
