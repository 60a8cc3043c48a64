package org.evoloop.study;

/**
 * What happens besides events, named as in {@code crash.sm}, {@code sight.sm} and {@code swap.sm}. Times are means of
 * exponential ones in seconds; 0 means never.
 *
 * <p>Threading: immutable.
 *
 * @param crash from when the converter is started until its process crashes
 * @param recovery from there until it is started again
 * @param journal whether it keeps a journal
 * @param sight for how long the device is in sight at a stretch
 * @param away for how long it is out of sight
 * @param operated how often a second somebody operates it meanwhile
 * @param swap from when models have taken over until others are to
 * @param pause how long no event can begin because others take over
 */
record Disturbances(
        double crash,
        double recovery,
        boolean journal,
        double sight,
        double away,
        double operated,
        double swap,
        double pause) {
    static final Disturbances NONE = new Disturbances(0, 0, false, 0, 0, 0, 0, 0);

    boolean isAny() {
        return crash > 0 || sight > 0 || swap > 0;
    }

    /** Whether they bring record and device apart. */
    boolean part() {
        return (crash > 0 && !journal) || operated > 0;
    }
}
