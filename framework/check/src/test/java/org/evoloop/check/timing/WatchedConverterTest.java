package org.evoloop.check.timing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.check.Lamp.lamp;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.RecordingExecute;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Probation;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Time properties of a running converter. */
class WatchedConverterTest {
    private static final ModelPair LAMP = new ModelPair(
            lamp("original").build(),
            lamp("new")
                    .transition("On", "dim", "Dim")
                    .transition("Dim", "alarm", "Off")
                    .transition("Dim", "press", "On")
                    .build());

    private final ManualClock clock = new ManualClock();
    private final Panel panel = new Panel();
    private final List<HistoryEntry> heard = new ArrayList<>();
    private final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("lamp", clock).withoutThreads());

    private static final class Panel extends PushMonitor {
        void pressed(String event) {
            push(fromPanel(event, false));
        }
    }

    private static final class Known extends StateKnowledge {
        Known(ModelPair models) {
            super(models);
        }

        @Override
        public void registerNewFunctions() {
            for (State state : models().evolved().states()) {
                if (models().isNew(state)) {
                    function(state.name(), NewFunction.none());
                }
            }
        }
    }

    private void start(String... lines) {
        TimeRules rules =
                PropertyFile.parse("lamp.txt", String.join("\n", lines), LAMP).time();
        converter.addMonitor(panel);
        converter.addExecute(new RecordingExecute("Lamp", "press"));
        converter.addKnowledge(new Known(LAMP));
        converter.watch((models, at, nanos) -> new TimeWatch(rules, models, at, nanos));
        converter.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                heard.add(entry);
            }
        });
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private void press(String... events) throws InterruptedException {
        for (String event : events) {
            panel.pressed(event);
            converter.observe(panel);
            steps();
        }
    }

    private void steps() {
        while (converter.step()) {
            // Until nothing is left to process.
        }
    }

    private void pass(Duration time) {
        clock.advance(time);
        steps();
    }

    private List<String> violations() {
        return converter.history().stream()
                .filter(entry -> entry.occurrence() instanceof Occurrence.Violated)
                .map(entry -> entry.occurrence().label())
                .toList();
    }

    @Test
    void whatLastsTooLongIsReportedWhenItDoes() throws InterruptedException {
        start("It is not dim for long: Dim never longer than 5 s");
        press("press", "dim");
        pass(Duration.ofSeconds(5));
        assertThat(violations()).isEmpty();

        pass(Duration.ofMillis(5));
        assertThat(violations()).containsExactly("violation of It is not dim for long");
        HistoryEntry entry = heard.get(heard.size() - 1);
        assertThat(entry.outcome()).isEqualTo(Outcome.FAILED);
        assertThat(entry.occurrence()).isInstanceOf(Occurrence.Violated.class);
        assertThat(entry.after().evolved()).hasToString("Dim");

        pass(Duration.ofHours(1));
        assertThat(violations()).hasSize(1);
        press("press", "dim");
        pass(Duration.ofSeconds(6));
        assertThat(violations()).hasSize(2);
    }

    @Test
    void whatComesInTimeViolatesNothing() throws InterruptedException {
        start("after Dim, On or Off within 2 s");
        press("press", "dim");
        pass(Duration.ofSeconds(2));
        press("press");
        pass(Duration.ofSeconds(60));
        assertThat(violations()).isEmpty();

        press("dim");
        pass(Duration.ofMillis(2001));
        assertThat(violations()).hasSize(1);
    }

    @Test
    void whatComesTooSoonOrTooOftenIsReportedAtOnce() throws InterruptedException {
        start("a: Dim only after 3 s of On", "b: event press at most 2 times in 1 s");
        press("press");
        pass(Duration.ofSeconds(2));
        press("dim");
        pass(Duration.ZERO);
        assertThat(violations()).containsExactly("violation of a");

        press("press", "press", "press");
        pass(Duration.ZERO);
        assertThat(violations()).containsExactly("violation of a", "violation of b");
    }

    @Test
    void anEventFollowsFromAViolation() throws InterruptedException {
        start("a: Dim never longer than 5 s", "on violation of a raise alarm");
        press("press", "dim");
        pass(Duration.ofMillis(5001));

        assertThat(converter.status().states().evolved()).hasToString("Off");
        HistoryEntry alarm = heard.get(heard.size() - 1);
        assertThat(alarm.occurrence().label()).isEqualTo("alarm");
        assertThat(alarm.occurrence().values().text("violated")).isEqualTo("a");
    }

    @Test
    void aViolationEndsATrialOfOtherModels() throws InterruptedException {
        start("a: Dim never longer than 5 s");
        ModelPair other = new ModelPair(LAMP.original(), LAMP.evolved().withName("other"));
        converter.evolve(Evolution.to(new Known(other)).withProbation(Probation.of(Duration.ofHours(1))));
        press("press", "dim");
        assertThat(converter.knowledge().models()).isSameAs(other);

        pass(Duration.ofMillis(5001));
        assertThat(converter.knowledge().models()).isSameAs(LAMP);
    }

    @Test
    void whileItIsClosedNothingThatIsRefusedCounts() throws InterruptedException {
        start("after event dim, Dim within 1 s");
        converter.stop();
        panel.pressed("dim");
        converter.observe(panel);
        pass(Duration.ofSeconds(5));
        assertThat(violations()).isEmpty();
    }
}
