package org.evoloop.benchmarks.ring;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.running.FloodedLoop;

/** The loop with a thread per component and bare rings, each in a flood, alternating in one process. */
public final class FloodTurns {
    private static final double LEAST = 0.7;
    private static final Duration WARM_UP = Duration.ofMillis(500);
    private static final Duration WATCHED = Duration.ofSeconds(1);
    private static final String LOOP = "flood";

    private FloodTurns() {}

    /**
     * Prints the medians over the turns, in events per second.
     *
     * @param arguments the number of turns
     */
    public static void main(String[] arguments) throws InterruptedException {
        int turns = Integer.parseInt(arguments[0]);
        Map<HandOff.Kind, List<Double>> rings = new EnumMap<>(HandOff.Kind.class);
        List<Double> loops = new ArrayList<>();
        for (int turn = 0; turn < turns; turn++) {
            for (HandOff.Kind kind : HandOff.Kind.values()) {
                rings.computeIfAbsent(kind, key -> new ArrayList<>()).add(BareFlood.rate(kind, WARM_UP, WATCHED));
            }
            try (FloodedLoop loop = new FloodedLoop(true)) {
                loops.add(loop.byThreads(WARM_UP, WATCHED));
            }
        }
        rings.forEach((kind, rates) -> System.out.println(kind + " " + median(rates)));
        System.out.println(LOOP + " " + median(loops));
    }

    private static double median(List<Double> rates) {
        return rates.stream().sorted(Comparator.naturalOrder()).toList().get(rates.size() / 2);
    }

    /** @param found the printed figures */
    static Row row(Figures found) {
        Map<String, Double> rings = new LinkedHashMap<>();
        for (HandOff.Kind kind : HandOff.Kind.values()) {
            rings.put(kind.label(), found.get(kind.toString()));
        }
        Map.Entry<String, Double> best =
                rings.entrySet().stream().max(Map.Entry.comparingByValue()).orElseThrow();
        return new Row(
                "flood of 4 monitors, threads",
                "events/s",
                found.get(LOOP),
                Row.Goal.atLeastTimes(LEAST, best.getKey(), best.getValue()),
                rings);
    }
}
