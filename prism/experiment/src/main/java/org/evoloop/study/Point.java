package org.evoloop.study;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

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
 * @param conversion conversion times
 * @param actionSeconds mean action time of the device for one event
 * @param holdOffSeconds mean hold-off time of {@link Mechanism#HOLDOFF}
 * @param disturbances what happens besides; not but for {@link Mechanism#PIPELINED}
 * @param seed of all random times
 */
record Point(
        String name,
        Mechanism mechanism,
        int capacity,
        int steps,
        double arrivalsPerSecond,
        ConversionTime conversion,
        double actionSeconds,
        double holdOffSeconds,
        Disturbances disturbances,
        long seed) {

    /** How converter and device go together. */
    enum Mechanism {
        /** The paper's: the device is sent events whether it is ready or not. */
        UNBUFFERED,
        /** The converter begins to convert when the device is ready. */
        SERIAL,
        /** The framework's own way: what is converted waits for the device. */
        PIPELINED,
        /** As {@link #PIPELINED}, but the device does not report when it is ready: a hold-off time replaces that. */
        HOLDOFF
    }

    /** How many columns {@link #parse} takes. */
    static final String COLUMNS =
            "name,mechanism,capacity,steps,arrivals_per_s,conversion_s,action_s,holdoff_s,seed,constants";

    private static final Set<String> CONSTANTS = Set.of(
            "phases",
            "first",
            "more",
            "last",
            "crash",
            "recovery",
            "journal",
            "sight",
            "away",
            "operated",
            "swap",
            "pause");

    /**
     * @param line comma separated values in the order of {@link #COLUMNS}; {@code constants} are {@code name=value} of
     *     {@link ConversionTime}, in place of {@code conversion_s}, and of {@link Disturbances}, separated by spaces
     * @throws IllegalArgumentException naming what does not fit
     */
    static Point parse(String line) {
        String[] cells = line.split(",", -1);
        if (cells.length != COLUMNS.split(",").length) {
            throw new IllegalArgumentException("'" + line + "' is not of the form " + COLUMNS);
        }
        try {
            Map<String, Double> constants = constants(cells[9]);
            Point point = new Point(
                    cells[0],
                    Mechanism.valueOf(cells[1].toUpperCase(Locale.ROOT)),
                    Integer.parseInt(cells[2]),
                    Integer.parseInt(cells[3]),
                    Double.parseDouble(cells[4]),
                    conversion(constants, cells[5]),
                    Double.parseDouble(cells[6]),
                    Double.parseDouble(cells[7]),
                    disturbances(constants),
                    Long.parseLong(cells[8]));
            if (point.capacity < 1 || point.steps < 1 || point.steps > 2) {
                throw new IllegalArgumentException("the capacity is at least 1, and steps is 1 or 2");
            }
            if (point.disturbances.isAny() && point.mechanism != Mechanism.PIPELINED) {
                throw new IllegalArgumentException("disturbances are for the mechanism pipelined");
            }
            return point;
        } catch (IllegalArgumentException cause) {
            throw new IllegalArgumentException("'" + line + "': " + cause.getMessage(), cause);
        }
    }

    private static Map<String, Double> constants(String cell) {
        Map<String, Double> constants = new HashMap<>();
        for (String assignment : cell.isBlank() ? new String[0] : cell.strip().split(" +")) {
            String[] sides = assignment.split("=", -1);
            if (sides.length != 2 || !CONSTANTS.contains(sides[0])) {
                throw new IllegalArgumentException("'" + assignment + "' gives none of " + CONSTANTS);
            }
            constants.put(sides[0], Double.parseDouble(sides[1]));
        }
        return constants;
    }

    private static ConversionTime conversion(Map<String, Double> constants, String mean) {
        return constants.containsKey("first")
                ? new ConversionTime(
                        (int) of(constants, "phases"),
                        of(constants, "first"),
                        of(constants, "more"),
                        of(constants, "last"))
                : ConversionTime.exponential(Double.parseDouble(mean));
    }

    private static Disturbances disturbances(Map<String, Double> constants) {
        return new Disturbances(
                of(constants, "crash"),
                of(constants, "recovery"),
                of(constants, "journal") > 0,
                of(constants, "sight"),
                of(constants, "away"),
                of(constants, "operated"),
                of(constants, "swap"),
                of(constants, "pause"));
    }

    private static double of(Map<String, Double> constants, String name) {
        return constants.getOrDefault(name, 0.0);
    }
}
