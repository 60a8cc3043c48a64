package org.evoloop.study;

import java.io.PrintStream;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * The measurements of one point, by quantity and time.
 *
 * <p>Threading: for one thread.
 */
final class Results {
    static final String COLUMNS = "point,quantity,t,n,mean,deviation";

    private final Map<Key, Samples> samples = new LinkedHashMap<>();

    private record Key(String quantity, int seconds) {}

    /** @param seconds what the quantity depends on, 0 if on nothing */
    void add(String quantity, int seconds, double value) {
        samples.computeIfAbsent(new Key(quantity, seconds), key -> new Samples())
                .add(value);
    }

    void print(String point, PrintStream out) {
        samples.forEach((key, values) -> out.printf(
                Locale.ROOT,
                "%s,%s,%d,%d,%.9g,%.9g%n",
                point,
                key.quantity(),
                key.seconds(),
                values.number(),
                values.mean(),
                values.deviation()));
    }
}
