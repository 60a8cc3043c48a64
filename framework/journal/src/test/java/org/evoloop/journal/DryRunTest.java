package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.Property;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.rehearsal.Difference;
import org.evoloop.rehearsal.Verdict;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Yesterday's events of a music player, replayed with the models drawn today. */
class DryRunTest {
    private static final StateMachine DEVICE = player("device").build();
    private static final ModelPair YESTERDAY = fading("tm(2s)", "Stopped");

    @TempDir
    private Path directory;

    private final ManualClock clock = new ManualClock();
    private boolean broken;

    /** Whether no step is answered. */
    private boolean silent;

    /** Where the device says that it is; null if it does not know. */
    private @Nullable String answer;

    private static StateMachineBuilder player(String name) {
        return StateMachine.named(name)
                .initial("Stopped")
                .transition("Stopped", "play", "Playing")
                .transition("Playing", "stop", "Stopped")
                .transition("Playing", "pause", "Paused")
                .transition("Paused", "play", "Playing");
    }

    /** A pair whose Fading ends after this time. */
    private static ModelPair fading(String timer, String end) {
        return new ModelPair(
                DEVICE,
                player("new")
                        .transition("Playing", "fade", "Fading")
                        .transition("Fading", timer, end)
                        .transition("Fading", "faded", "Stopped")
                        .build());
    }

    private final class Buttons extends PushMonitor {
        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("stop");
        }

        private void acted(String event) {
            push(fromPanel(event, true));
        }
    }

    private final class Device extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("play", "stop", "pause");
        }

        @Override
        protected void send(Step step) throws IOException {
            if (broken) {
                throw new IOException("the cable is out");
            }
            if (silent) {
                throw new UnknownEffectException("no answer");
            }
        }

        @Override
        protected Optional<String> locate() {
            return Optional.ofNullable(answer);
        }

        private void obeysLate() {
            tookEffect();
        }
    }

    /**
     * Runs one process. A deed is a press, or several at once joined by {@code +}; with {@code !} one of the device's
     * own buttons; {@code late} if the device obeys a step that was not answered; or a number of milliseconds to wait.
     */
    private void live(NewFunction function, String... deeds) throws InterruptedException {
        Buttons buttons = new Buttons();
        SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("player", clock).withoutThreads());
        converter.addMonitor(buttons);
        Device device = new Device();
        converter.addExecute(device);
        converter.addKnowledge(new StateKnowledge(YESTERDAY) {
            @Override
            protected void registerNewFunctions() {
                function("Fading", function);
            }
        });
        converter.journal(Journal.in(directory).withForcing(Forcing.NEVER));
        converter.build();
        converter.start();
        for (String deed : deeds) {
            clock.advance(Duration.ofMillis(1));
            if (Character.isDigit(deed.charAt(0))) {
                clock.advance(Duration.ofMillis(Long.parseLong(deed)));
            } else if (deed.equals("late")) {
                device.obeysLate();
            } else if (deed.startsWith("!")) {
                buttons.acted(deed.substring(1));
            } else {
                for (String event : deed.split("\\+")) {
                    buttons.press(event);
                    converter.observe(buttons);
                }
            }
            converter.observe(buttons);
            while (converter.step()) {
                // Processes everything that waits.
            }
        }
        converter.close();
    }

    private DryRun.Result run(ModelPair models, String... properties) {
        PropertyFile file = PropertyFile.parse("new.properties.txt", String.join("\n", properties), models);
        return DryRun.of(new JournalFiles(directory), models, file.properties());
    }

    private List<String> outcomes(ModelPair models) {
        return run(models).differences().stream()
                .map(each -> each.occurrence().label() + " | " + each.recorded() + " | " + each.other())
                .toList();
    }

    @Test
    void theSameModelsDecideTheSame() throws InterruptedException {
        live(NewFunction.none(), "play", "fade", "2500", "play", "!stop", "fade", "play", "pause", "play", "stop");
        broken = true;
        live(NewFunction.none(), "play");
        broken = false;
        live(visit -> visit.finishAfter(Duration.ofMillis(700), "faded"), "play", "fade", "900", "play");
        DryRun.Result result = run(YESTERDAY);
        assertThat(result.differences()).isEmpty();
        assertThat(result.events()).isEqualTo(15);
    }

    @Test
    void aDeviceThatWasInDoubtWasWhereItWasFound() throws InterruptedException {
        silent = true;
        answer = "Playing";
        live(NewFunction.none(), "play+pause");
        silent = false;
        live(NewFunction.none(), "play", "fade", "2500");

        DryRun.Result same = run(YESTERDAY);
        assertThat(same.differences()).isEmpty();
        assertThat(same.events()).as("with the device, found in Playing").isEqualTo(6);
        assertThat(outcomes(fading("tm(2s)", "Paused")))
                .hasSize(1)
                .first()
                .asString()
                .startsWith("tm(2s) | ");
    }

    @Test
    void aStepThatHadItsEffectLateHadIt() throws InterruptedException {
        silent = true;
        live(NewFunction.none(), "play", "late");
        silent = false;
        live(NewFunction.none(), "pause");

        DryRun.Result same = run(YESTERDAY);
        assertThat(same.differences()).isEmpty();
        assertThat(same.events()).isEqualTo(3);
        assertThat(outcomes(new ModelPair(DEVICE, player("new").build()))).isEmpty();
    }

    @Test
    void differentDecisionsAreReportedWithBothReasons() throws InterruptedException {
        live(NewFunction.none(), "play", "fade", "2500", "stop");
        assertThat(outcomes(fading("tm(2s)", "Paused")))
                .containsExactly(
                        "tm(2s) | (Playing, Fading) -> (Stopped, Stopped), sends stop: existing-function"
                                + " | (Playing, Fading) -> (Paused, Paused), sends pause: existing-function",
                        "stop | stays in (Stopped, Stopped): not-acceptable | stays in (Paused, Paused): not-acceptable");
    }

    @Test
    void timersAreDueWhenTheOtherModelsHaveThem() throws InterruptedException {
        live(NewFunction.none(), "play", "fade", "2500", "5000", "play");
        List<Difference> differences = run(fading("tm(4s)", "Stopped")).differences();
        assertThat(differences).hasSize(2);
        assertThat(differences.get(0).occurrence().label()).isEqualTo("tm(2s)");
        assertThat(differences.get(0).other()).isNull();
        assertThat(differences.get(1).occurrence().label()).isEqualTo("tm(4s)");
        assertThat(differences.get(1).recorded()).isNull();
        assertThat(Duration.between(differences.get(0).at(), differences.get(1).at()))
                .isEqualTo(Duration.ofSeconds(2));
    }

    /** However long after that the next event comes. */
    @Test
    void timersThatOnlyTheOtherModelsHaveFireWhenTheyAreDue() throws InterruptedException {
        live(NewFunction.none(), "play", "1500", "pause", "700", "stop");
        ModelPair slow = new ModelPair(
                DEVICE,
                StateMachine.named("slow")
                        .initial("Stopped")
                        .transition("Stopped", "play", "Waking")
                        .transition("Waking", "tm(1s)", "Warm")
                        .transition("Warm", "tm(1s)", "Playing")
                        .transition("Playing", "stop", "Stopped")
                        .transition("Playing", "pause", "Paused")
                        .transition("Paused", "play", "Playing")
                        .build());
        List<Difference> differences = run(slow).differences();
        assertThat(differences)
                .extracting(each -> each.occurrence().label())
                .containsExactly("play", "tm(1s)", "pause", "tm(1s)", "stop");
        assertThat(Duration.between(differences.get(0).at(), differences.get(1).at()))
                .isEqualTo(Duration.ofSeconds(1));
        assertThat(Duration.between(differences.get(0).at(), differences.get(3).at()))
                .isEqualTo(Duration.ofSeconds(2));
    }

    @Test
    void whatAFunctionRaisedHappensOnlyWhereItRuns() throws InterruptedException {
        live(visit -> visit.finishAfter(Duration.ofMillis(700), "faded"), "play", "fade", "900");
        ModelPair without = new ModelPair(
                DEVICE, player("new").transition("Playing", "fade", "Paused").build());
        List<Difference> differences = run(without).differences();
        assertThat(differences).extracting(each -> each.occurrence().label()).containsExactly("fade", "faded");
        assertThat(differences.get(1).other()).isNull();
        assertThat(differences.get(1).recorded()).extracting(Verdict::outcome).isEqualTo(Outcome.HANDLED);
    }

    @Test
    void aPropertyIsBrokenByAnEventAndOpenAtTheEnd() throws InterruptedException {
        live(NewFunction.none(), "play", "fade", "2500", "play", "!stop", "play");
        DryRun.Result result = run(
                fading("tm(2s)", "Paused"),
                "no pause: never device Paused",
                "Fading only after event play",
                "always can Stopped",
                "always event play implies eventually event pause");
        assertThat(result.broken()).singleElement().satisfies(broken -> {
            assertThat(broken.property().name()).isEqualTo("no pause");
            assertThat(broken.occurrence()).isNotNull();
            assertThat(broken.occurrence().label()).isEqualTo("tm(2s)");
            assertThat(broken.where()).hasToString("(Paused, Paused)");
            assertThat(broken.at()).isEqualTo(result.differences().get(0).at());
        });
        assertThat(result.open()).extracting(Property::line).containsExactly(4);
        assertThat(run(YESTERDAY, "never device Paused").broken()).isEmpty();
    }

    @Test
    void whatHoldsNoMoreWhereTheJournalBeginsHasNoEvent() throws InterruptedException {
        live(NewFunction.none(), "play");
        live(NewFunction.none(), "pause");
        assertThat(run(YESTERDAY, "never Stopped").broken()).singleElement().satisfies(broken -> {
            assertThat(broken.occurrence()).isNull();
            assertThat(broken.where()).hasToString("(Stopped, Stopped)");
        });
        assertThat(run(YESTERDAY, "Paused only after Playing", "next Playing").broken())
                .as("across a restart")
                .isEmpty();
    }

    @Test
    void aJournalThatIsNotThereIsNamed() {
        assertThatThrownBy(() -> DryRun.of(new JournalFiles(directory.resolve("nowhere")), YESTERDAY, List.of()))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("nowhere does not exist");
    }
}
