package org.evoloop.study;

/**
 * Counts independent values of one quantity and sums them up (Welford's method).
 *
 * <p>Threading: for one thread.
 */
final class Samples {
    private long number;
    private double mean;
    private double squares;

    void add(double value) {
        number++;
        double off = value - mean;
        mean += off / number;
        squares += off * (value - mean);
    }

    long number() {
        return number;
    }

    double mean() {
        return mean;
    }

    /** The sample standard deviation; 0 for less than two values. */
    double deviation() {
        return number < 2 ? 0 : Math.sqrt(squares / (number - 1));
    }
}
