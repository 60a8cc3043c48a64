package org.evoloop.fleet.wire;

import java.util.Locale;

/**
 * The topics of a fleet. Each is keyed by the device's id, except {@link #MODELS} (version) and {@link #ROLLOUTS} and
 * {@link #VERDICTS} (the rollout's name).
 *
 * @since 0.1
 */
public enum Topic {
    /** In: which device has which models. The last record of a key counts. */
    DEVICES(true, true),
    /** In: what was observed at devices. */
    OCCURRENCES(true, false),
    /** In: the outcomes of commands. */
    EFFECTS(true, false),
    /** Out: what is to be carried out at the device. */
    COMMANDS(true, false),
    /** Out: the outcomes of occurrences. */
    DECISIONS(true, false),
    /** Out: the states of devices. The last record of a key counts. */
    STATES(true, true),
    /** Out: records that could not be processed, and why. */
    DEAD_LETTERS(false, false),
    /** In: models, by version. The last record of a key counts. */
    MODELS(false, true),
    /** In and out: which models replace which, where, and how far that has got. The last record of a key counts. */
    ROLLOUTS(false, true),
    /** Internal: the results of devices that have the models of a rollout. */
    VERDICTS(false, false);

    private final boolean byDevice;
    private final boolean compacted;

    Topic(boolean byDevice, boolean compacted) {
        this.byDevice = byDevice;
        this.compacted = compacted;
    }

    /**
     * Whether it is partitioned by device. All such topics have the same number of partitions, so that the records of a
     * device are in the same partition.
     */
    public boolean isByDevice() {
        return byDevice;
    }

    /** Whether only the last record of a key counts. */
    public boolean isCompacted() {
        return compacted;
    }

    /** Its name in the fleet {@code fleet}, such as {@code evoloop.dead-letters}. */
    public String of(String fleet) {
        return fleet + '.' + name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
