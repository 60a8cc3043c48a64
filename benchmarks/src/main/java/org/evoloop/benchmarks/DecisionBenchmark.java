package org.evoloop.benchmarks;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** One look-up in the decision table of the paper's cleaning robot, and in a map of strings as a yardstick. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class DecisionBenchmark {
    private final DecisionTable table;
    private final List<Situation> situations = new ArrayList<>();
    private final Map<String, Decision> yardstick = new HashMap<>();
    private int position;

    /** An event in a configuration, and both as one text. */
    private record Situation(Configuration at, Event event, String text) {}

    /** Every event in every configuration that can be reached. */
    public DecisionBenchmark() {
        ModelPair pair = PaperModels.cleaningRobot();
        Set<Event> buttons = Set.of(new Event("Clean"), new Event("Spot"));
        table = DecisionTable.compile(pair, new DeviceEvents(buttons, buttons));
        for (Configuration at : table.configurations()) {
            for (Event event : pair.evolved().events()) {
                Situation situation = new Situation(at, event, at + " " + event);
                situations.add(situation);
                yardstick.put(situation.text(), table.decide(at, event, false));
            }
        }
    }

    private Situation next() {
        position = position + 1 == situations.size() ? 0 : position + 1;
        return situations.get(position);
    }

    @Benchmark
    public Decision byEvent() {
        Situation situation = next();
        return table.decide(situation.at(), situation.event(), false);
    }

    /** As a monitor does it, which knows the event's name. */
    @Benchmark
    public Decision byName() {
        Situation situation = next();
        return table.decide(situation.at(), new Event(situation.event().name()), false);
    }

    /** A raw look-up among as many keys. */
    @Benchmark
    public @Nullable Decision hashMapOfStrings() {
        return yardstick.get(next().text());
    }
}
