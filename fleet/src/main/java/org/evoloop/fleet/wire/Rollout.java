package org.evoloop.fleet.wire;

import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import org.evoloop.fleet.device.Model;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.ModelException;

/**
 * Models that take over from others in a share of the fleet, as it stands in {@link Topic#ROLLOUTS}.
 *
 * @param name of the rollout: a greater share under the same name takes in more devices, and all of those before
 * @param from the version that is left
 * @param to the version that takes over
 * @param percent of the devices that have {@code from}, 0 to 100
 * @param mapping what does not go by its name, as in the files of {@code evoloop models migrate}
 * @param stopPercent it stops if more than so many of what happens to these devices are failures or divergences
 * @param stopAfter once so many were counted
 * @param stopped why it has stopped, and leads back; empty while it goes on
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

    /** Reads what {@link #bytes} has written. */
    public static Rollout read(String name, byte[] bytes) {
        Reading record = Reading.of(bytes);
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
        return new Json()
                .with("from", from)
                .with("to", to)
                .with("percent", percent)
                .withText("mapping", mapping)
                .with("stopPercent", stopPercent)
                .with("stopAfter", stopAfter)
                .withText("stopped", stopped)
                .bytes();
    }

    /** The same with another share. */
    public Rollout withPercent(double other) {
        return new Rollout(name, from, to, other, mapping, stopPercent, stopAfter, stopped);
    }

    /** The same, which leads back. */
    public Rollout stoppedBecause(String why) {
        return new Rollout(name, from, to, percent, mapping, stopPercent, stopAfter, why);
    }

    /**
     * How it leads from the models {@code one} to {@code other}, which are those that it names; the other way if it
     * leads back.
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

    /** Whether it still leads from {@link #from} to {@link #to}. */
    public boolean isRolling() {
        return stopped.isEmpty();
    }

    /** Whether it is for {@code device}: by the device's id, so that each share contains the smaller ones. */
    public boolean takesIn(String device) {
        CRC32 sum = new CRC32();
        sum.update((name + '/' + device).getBytes(StandardCharsets.UTF_8));
        return sum.getValue() * 100.0 / (1L << 32) < percent;
    }
}
