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
 * What the fleet stores for a lamp and writes, record by record of the {@link Traffic}; the bare topology stores and writes
 * the same.
 *
 * @param steps the registration, then the records of a cycle, which is repeated
 */
record Exchange(List<Step> steps) {
    private static final long PATIENCE_NANOS = 30_000_000_000L;

    /** The bytes stored after a record, and the records written because of it. */
    @SuppressWarnings("ArrayRecordComponent") // steps are not compared
    record Step(byte[] stored, List<Letters.Letter> letters) {}

    /** @param cycles how often each lamp goes through the cycle; its counters, and so the bytes, grow meanwhile */
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
