package org.evoloop.fleet.stream;

import java.util.LinkedHashMap;
import java.util.Map;
import org.evoloop.fleet.device.Kept;

/** What is kept of the devices at which something happened last, as it lies in the store: reading it takes longer than all else. */
final class Recent extends LinkedHashMap<String, Kept> {
    private static final int MOST = 10_000;
    private static final float LOAD = 0.75f;

    Recent() {
        super(1_024, LOAD, true);
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<String, Kept> eldest) {
        return size() > MOST;
    }
}
