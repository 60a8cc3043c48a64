package org.evoloop.fleet.wire;

import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import org.evoloop.fleet.device.Model;
import org.evoloop.migration.Mapping;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.ModelException;

/**
 * A rollout in {@link Topic#ROLLOUTS}: models that take over from others in a share of the fleet.
 *
 * @param name the rollout's name: a greater share under the same name includes all earlier devices and more
 * @param from the old version
 * @param to the new version
 * @param percent the share of the devices that have {@code from}, 0 to 100
 * @param mapping the exceptions from mapping by name, as in the files of {@code evoloop models migrate}
 * @param stopPercent it stops if a higher percentage of these devices' results are failures or divergences
 * @param stopAfter the number of results before it may stop
 * @param stopped why it has stopped and is rolled back; empty while it continues
 * @since 0.1
 */
public record Rollout(
        String name,
        String from,
        String to,
        double percent,
        String mapping,
        double stopPercent,
        long stopAfter,
        String stopped) {

    /** Parses the result of {@link #bytes}. */
    public static Rollout read(String name, byte[] bytes) {
        JsonRecord record = Reading.of(bytes).record();
        return new Rollout(
                name,
                record.text("from"),
                record.text("to"),
                record.fraction("percent", 100),
                record.text("mapping", ""),
                record.fraction("stopPercent", 5),
                record.number("stopAfter", 20),
                record.text("stopped", ""));
    }

    /** The record. */
    public byte[] bytes() {
        return Wire.record(Wire.SCHEMA)
                .put("from", from)
                .put("to", to)
                .put("percent", percent)
                .putSome("mapping", mapping)
                .put("stopPercent", stopPercent)
                .put("stopAfter", stopAfter)
                .putSome("stopped", stopped)
                .toBytes();
    }

    /** A copy with another share. */
    public Rollout withPercent(double other) {
        return new Rollout(name, from, to, other, mapping, stopPercent, stopAfter, stopped);
    }

    /** A copy that is rolled back. */
    public Rollout stoppedBecause(String why) {
        return new Rollout(name, from, to, percent, mapping, stopPercent, stopAfter, why);
    }

    /**
     * The takeover from the models {@code one} to {@code other}, the two of this rollout; in the reverse direction if
     * it is rolled back.
     *
     * @throws ModelException if the mapping does not fit them
     */
    public Model.Takeover takeover(Model one, Model other) {
        Mapping mapping = Mapping.parse(
                "rollout " + name,
                this.mapping,
                one.rules().table().models(),
                other.rules().table().models());
        return isRolling() ? one.to(other, mapping) : other.to(one, mapping.reversed());
    }

    /** Whether it is still in progress, from {@link #from} to {@link #to}, and not rolled back. */
    public boolean isRolling() {
        return stopped.isEmpty();
    }

    /** The version that its devices leave now. */
    public String leaves() {
        return isRolling() ? from : to;
    }

    /** The version that its devices get now. */
    public String reaches() {
        return isRolling() ? to : from;
    }

    /** Whether it includes {@code device}, decided by the device's id, so that each share contains the smaller ones. */
    public boolean takesIn(String device) {
        CRC32 sum = new CRC32();
        sum.update((name + '/' + device).getBytes(StandardCharsets.UTF_8));
        return sum.getValue() * 100.0 / (1L << 32) < percent;
    }
}
