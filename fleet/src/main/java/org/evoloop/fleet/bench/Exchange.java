package org.evoloop.fleet.bench;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.fleet.device.Device;
import org.evoloop.fleet.device.DeviceStateBytes;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.wire.Letters;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Wire;

/**
 * What the fleet keeps of a lamp and writes, record by record of the {@link Traffic}: the bare topology keeps and writes
 * the same.
 *
 * @param steps the registration, then a cycle's records, which come again and again
 */
record Exchange(List<Step> steps) {
    private static final long PATIENCE_NANOS = 30_000_000_000L;

    /** What is kept after a record, and what is written because of it. */
    @SuppressWarnings("ArrayRecordComponent") // nobody compares steps
    record Step(byte[] kept, List<Letters.Letter> letters) {}

    /** @param cycles how often each lamp goes through the cycle, since what is counted gets longer */
    static Exchange with(ModelRecord lamp, int cycles) {
        Model model = ModelRecord.read("lamp", lamp.bytes());
        long at = Wire.nanos(System.currentTimeMillis());
        Letters letters = new Letters();
        letters.begin(model.version(), null);
        Device device = new Device(model, PATIENCE_NANOS, letters, at);
        Step registered = step(device, letters);
        List<Step> steps = new ArrayList<>();
        for (int cycle = 1; cycle <= cycles; cycle++) {
            steps.clear();
            steps.add(registered);
            letters.begin(model.version(), device.state());
            device.observed(Traffic.press(at));
            steps.add(step(device, letters));
            letters.begin(model.version(), device.state());
            device.answered(Traffic.sent(cycle, at));
            steps.add(step(device, letters));
            letters.begin(model.version(), device.state());
            device.observed(Traffic.switchedOff(at));
            steps.add(step(device, letters));
        }
        return new Exchange(steps);
    }

    private static Step step(Device device, Letters letters) {
        return new Step(DeviceStateBytes.write(device.state()), List.copyOf(letters.all()));
    }

    /** The number of the step after that of this number. */
    int after(int step) {
        return step + 1 < steps.size() ? step + 1 : 1;
    }
}
