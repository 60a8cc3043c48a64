package org.evoloop.study;

import java.util.Locale;

/**
 * One set of parameters, named as in the study's models.
 *
 * <p>Threading: immutable.
 *
 * @param name what the results are called by
 * @param mechanism how converter and device go together
 * @param capacity events the converter can hold, the one in the loop included; at least 1
 * @param steps events sent for one decision, 1 or 2
 * @param arrivalsPerSecond mean rate of the controller's events
 * @param conversionSeconds mean conversion time
 * @param actionSeconds mean action time of the device for one event
 * @param holdOffSeconds mean hold-off time of {@link Mechanism#HOLDOFF}
 * @param seed of all random times
 */
record Point(
        String name,
        Mechanism mechanism,
        int capacity,
        int steps,
        double arrivalsPerSecond,
        double conversionSeconds,
        double actionSeconds,
        double holdOffSeconds,
        long seed) {

    /** How converter and device go together. */
    enum Mechanism {
        /** The paper's: the device is sent events whether it is ready or not. */
        UNBUFFERED,
        /** The converter begins to convert when the device is ready. */
        SERIAL,
        /** The framework's own way: what is converted waits for the device. */
        PIPELINED,
        /** As {@link #PIPELINED}, but the device does not tell when it is ready: a hold-off time stands for that. */
        HOLDOFF
    }

    /** How many columns {@link #parse} takes. */
    static final String COLUMNS = "name,mechanism,capacity,steps,arrivals_per_s,conversion_s,action_s,holdoff_s,seed";

    /**
     * @param line comma separated values in the order of {@link #COLUMNS}
     * @throws IllegalArgumentException naming what does not fit
     */
    static Point parse(String line) {
        String[] cells = line.split(",", -1);
        if (cells.length != COLUMNS.split(",").length) {
            throw new IllegalArgumentException("'" + line + "' is not of the form " + COLUMNS);
        }
        try {
            Point point = new Point(
                    cells[0],
                    Mechanism.valueOf(cells[1].toUpperCase(Locale.ROOT)),
                    Integer.parseInt(cells[2]),
                    Integer.parseInt(cells[3]),
                    Double.parseDouble(cells[4]),
                    Double.parseDouble(cells[5]),
                    Double.parseDouble(cells[6]),
                    Double.parseDouble(cells[7]),
                    Long.parseLong(cells[8]));
            if (point.capacity < 1 || point.steps < 1 || point.steps > 2) {
                throw new IllegalArgumentException("the capacity is at least 1, and steps is 1 or 2");
            }
            return point;
        } catch (IllegalArgumentException cause) {
            throw new IllegalArgumentException("'" + line + "': " + cause.getMessage(), cause);
        }
    }
}
