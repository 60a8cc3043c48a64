package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.LongStream;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.Moment;
import org.evoloop.check.temporal.Outlook;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.temporal.PropertyWatch;
import org.evoloop.engine.Core;
import org.evoloop.engine.Output;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The outputs of a core in random runs break no property that the model checker found to hold for its models. */
class WatchedCoreTest {
    private static final int EVENTS = 200;
    private static final long MILLISECOND = 1_000_000;
    private static final ModelPair MODELS = Robot.MODELS;
    private static final Rules RULES = Robot.RULES;

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 20), LongStream.of(new Random().nextLong()));
    }

    private static List<Property> candidates() {
        List<String> lines = new ArrayList<>();
        for (State state : MODELS.evolved().states()) {
            for (State other : MODELS.evolved().states()) {
                lines.add("always (" + state + " implies next not " + other + ")");
                lines.add(state + " only after " + other);
            }
            for (State device : MODELS.original().states()) {
                lines.add("always (" + state + " implies device " + device + ")");
            }
            for (Event event : MODELS.evolved().triggers()) {
                lines.add("never (" + state + " and event " + event + ")");
            }
            lines.add("always can " + state);
        }
        return PropertyFile.parse("robot.properties.txt", String.join("\n", lines), MODELS)
                .properties();
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void whatHoldsForTheModelsIsNotBroken(long seed) {
        Outlook outlook = new Outlook(RULES.table());
        Configuration initial = MODELS.initial();
        List<Property> candidates = candidates();
        List<Property> holding = candidates.stream()
                .filter(each -> outlook.holds(each.formula(), new Moment(initial, null)))
                .toList();
        assertThat(holding).hasSizeBetween(20, candidates.size() - 20);
        PropertyWatch watch = new PropertyWatch(candidates, RULES.table(), initial);
        run(new Random(seed), watch, initial);
        assertThat(watch.broken()).as("seed %d", seed).isNotEmpty().doesNotContainAnyElementsOf(holding);
    }

    private static void run(Random random, PropertyWatch watch, Configuration initial) {
        List<Output> said = new ArrayList<>();
        Core core = new Core(RULES, said::add);
        core.opened(0);
        assertThat(core.at()).isEqualTo(initial);
        long now = 0;
        for (int number = 0; number < EVENTS; number++) {
            now += random.nextInt(4000) * MILLISECOND + 1;
            fire(core, now);
            String event = List.of("Clean", "Spot", "arriveSpot", "endSpot").get(random.nextInt(4));
            boolean own = event.equals("endSpot");
            boolean here = core.at().original().name().equals("Spot");
            if (!own || here) {
                core.observed(new Occurrence.Heard(
                        new Event(event),
                        Values.NONE,
                        own ? Source.DEVICE : Source.CONTROLLER,
                        own,
                        Set.of(),
                        Occurrence.ANY_VISIT,
                        now));
            }
            carryOut(core, now);
            for (Output output : said) {
                if (output instanceof Output.Ended ended) {
                    watch.ended(ended.occurrence(), ended.after(), ended.outcome(), ended.decision());
                }
            }
            said.clear();
        }
    }

    private static void fire(Core core, long now) {
        Snapshot.OpenVisit visit = core.snapshot().visit();
        visit.deadlines().forEach((timer, due) -> {
            if (due <= now) {
                core.timerDue(visit.number(), timer, due);
                carryOut(core, due);
            }
        });
    }

    /** Every step and effect succeeds at once. */
    private static void carryOut(Core core, long now) {
        for (core.ready(); core.isBusy(); core.ready()) {
            Pending pending = core.snapshot().work().pending();
            long number = pending.number();
            core.planned(number, RULES.decide(core.at(), core.steps(), pending, guard -> false), now);
            while (core.isBusy()) {
                core.sending(number);
                core.sent(number, true, now);
                core.running(number);
                core.effectRun(number, "", now);
            }
        }
    }
}
