package org.evoloop.study;

/**
 * How long conversions take: a Coxian distribution, named as in {@code phases.sm}.
 *
 * <p>Threading: immutable.
 *
 * @param phases exponential phases of every conversion, at least 1
 * @param first mean time of each of them in seconds
 * @param more the probability of one more phase
 * @param last mean time of that one in seconds
 */
record ConversionTime(int phases, double first, double more, double last) {
    ConversionTime {
        if (phases < 1 || first <= 0 || more < 0 || more >= 1 || (more > 0 && last <= 0)) {
            throw new IllegalArgumentException(
                    "phases is at least 1, first and last are above 0, more is from 0 to below 1");
        }
    }

    static ConversionTime exponential(double meanSeconds) {
        return new ConversionTime(1, meanSeconds, 0, 0);
    }
}
