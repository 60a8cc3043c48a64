package org.evoloop.benchmarks.drawing;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * A logarithmic axis over whole decades.
 *
 * <p>Threading: immutable.
 *
 * @param lowest the power of ten at its left end
 * @param decades the number of decades
 * @param left its left end, in pixels
 * @param width in pixels
 */
record LogAxis(int lowest, int decades, double left, double width) {

    /** The shortest axis of whole decades that contains these values, all above 0. */
    static LogAxis over(DoubleStream values, double left, double width) {
        double[] logarithms = values.map(Math::log10).sorted().toArray();
        int lowest = (int) Math.floor(logarithms[0]);
        int highest = (int) Math.ceil(logarithms[logarithms.length - 1]);
        return new LogAxis(lowest, Math.max(1, highest - lowest), left, width);
    }

    /** The position of a value, in pixels. */
    double x(double value) {
        return left + (Math.log10(value) - lowest) / decades * width;
    }

    /** The values with grid lines: the powers of ten. */
    List<Double> marks() {
        return IntStream.rangeClosed(lowest, lowest + decades)
                .mapToObj(power -> Math.pow(10, power))
                .toList();
    }
}
