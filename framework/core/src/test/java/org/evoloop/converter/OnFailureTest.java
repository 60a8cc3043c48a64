package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A lift goes to the fourth floor by plans of several steps, one of which fails. */
class OnFailureTest {
    private static final ModelPair MODELS = new ModelPair(
            machine(
                    "lift",
                    "F0 up -> F1",
                    "F1 up -> F2",
                    "F2 up -> F3",
                    "F3 up -> F4",
                    "F1 down -> F0",
                    "F2 down -> F1",
                    "F3 down -> F2",
                    "F4 down -> F3",
                    "F2 express -> F4"),
            machine(
                    "new",
                    "F0 top -> F4",
                    "F0 up -> F1",
                    "F1 up -> F2",
                    "F2 up -> F3",
                    "F3 up -> F4",
                    "F1 down -> F0",
                    "F2 down -> F1",
                    "F3 down -> F2",
                    "F4 down -> F3",
                    "F2 express -> F4",
                    "F0 wait -> Waiting",
                    "Waiting top -> F4",
                    "Waiting over -> F0"));

    private final List<String> sent = new ArrayList<>();
    private final Set<String> broken = new HashSet<>();
    private final Set<String> unknown = new HashSet<>();
    private int begun;
    private SystemEventConverter converter;
    private final PushMonitor buttons = new PushMonitor("Buttons");

    @AfterEach
    void close() {
        converter.close();
    }

    private final class Lift extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("up", "down", "express");
        }

        @Override
        protected void send(Step step) throws UnknownEffectException {
            if (broken.contains(step.source() + " " + step.trigger())) {
                throw new IllegalStateException("stuck at " + step.source());
            }
            if (unknown.contains(step.source() + " " + step.trigger())) {
                throw new UnknownEffectException("no answer");
            }
            sent.add(step.trigger().name());
        }
    }

    private abstract class Floors extends StateKnowledge {
        Floors() {
            super(MODELS);
        }

        abstract void more();

        void onFailure(OnFailure then) {
            onFailure("F0", "top", then);
            onFailure("Waiting", "top", then);
        }

        @Override
        protected void registerNewFunctions() {
            function("Waiting", visit -> begun++);
            more();
        }
    }

    private void build(OnFailure then, String... steps) {
        broken.addAll(List.of(steps));
        converter = new SystemEventConverter(
                LoopConfig.defaults("lift", new ManualClock()).withoutThreads());
        converter.addMonitor(buttons);
        converter.addExecute(new Lift());
        converter.addKnowledge(new Floors() {
            @Override
            void more() {
                onFailure(then);
            }
        });
        converter.build();
        converter.start();
    }

    private HistoryEntry press(String event) throws InterruptedException {
        buttons.press(event);
        converter.observe(buttons);
        while (converter.step()) {
            // One after the other.
        }
        List<HistoryEntry> history = converter.history();
        return history.get(history.size() - 1);
    }

    private static String reason(HistoryEntry entry) {
        return entry.decision() instanceof Decision.Impossible impossible ? impossible.reason() : "";
    }

    private String states() {
        return converter.knowledge().configuration().toString();
    }

    @Test
    void theDeviceStaysWhereItIs() throws Exception {
        build(OnFailure.STAY, "F2 express");
        HistoryEntry top = press("top");
        assertThat(sent).containsExactly("up", "up");
        assertThat(states()).isEqualTo("(F2, F0)");
        assertThat(top.outcome()).hasToString("FAILED");
        assertThat(top.detail()).contains("stuck at F2");
    }

    @Test
    void theDeviceGoesBackToWhereThePlanBegan() throws Exception {
        build(OnFailure.GO_BACK, "F2 express");
        HistoryEntry top = press("top");
        assertThat(sent).containsExactly("up", "up", "down", "down");
        assertThat(states()).isEqualTo("(F0, F0)");
        assertThat(top.outcome()).hasToString("FAILED");
        assertThat(reason(top)).contains("stuck at F2; the device goes back to F0");
        assertThat(converter.history()).as("one event, one ending").hasSize(1);
        broken.clear();
        press("top");
        assertThat(states()).isEqualTo("(F4, F4)");
    }

    @Test
    void theFunctionThatWasLeftBeginsAgain() throws Exception {
        build(OnFailure.GO_BACK, "F2 express");
        press("wait");
        press("top");
        assertThat(states()).isEqualTo("(F0, Waiting)");
        assertThat(begun).as("the state was left with the first step").isEqualTo(2);
        assertThat(press("over").outcome()).hasToString("HANDLED");
    }

    @Test
    void theFirstStepLeavesNothingToGoBackFrom() throws Exception {
        build(OnFailure.GO_BACK, "F0 up");
        HistoryEntry top = press("top");
        assertThat(sent).isEmpty();
        assertThat(top.detail()).contains("stuck at F0").doesNotContain("goes back");
    }

    @Test
    void aLockDoesNotKeepTheDeviceFromGoingBack() throws Exception {
        build(OnFailure.GO_BACK, "F2 express");
        converter.exchange("EventAnalyze", new EventAnalyze("Lock") {
            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                return sent.isEmpty() ? super.analyze(occurrence) : refuse(occurrence, "the lift moves");
            }
        });
        HistoryEntry top = press("top");
        assertThat(states()).isEqualTo("(F0, F0)");
        assertThat(top.outcome()).hasToString("FAILED");
        assertThat(reason(top)).contains("stuck at F2; the device goes back to F0");
        assertThat(press("up").detail()).isEqualTo("the lift moves");
    }

    @Test
    void whatFailsOnTheWayBackStaysThere() throws Exception {
        build(OnFailure.GO_BACK, "F2 express", "F1 down");
        HistoryEntry top = press("top");
        assertThat(sent).containsExactly("up", "up", "down");
        assertThat(states()).isEqualTo("(F1, F0)");
        assertThat(top.detail()).contains("stuck at F2").contains("; then ").contains("stuck at F1");
    }

    @Test
    void whyTheWayBackWasTakenIsToldIfItsEffectIsUnknown() throws Exception {
        unknown.add("F1 down");
        build(OnFailure.GO_BACK, "F2 express");
        press("top");
        assertThat(converter.history())
                .filteredOn(entry -> entry.occurrence().label().equals("top"))
                .singleElement()
                .satisfies(top -> assertThat(top.detail())
                        .contains("stuck at F2")
                        .contains("; then ")
                        .contains("no answer"));
    }

    @Test
    void theEventContinuesByAnotherPath() throws Exception {
        build(OnFailure.OTHER_WAY, "F2 express");
        HistoryEntry top = press("top");
        assertThat(sent).containsExactly("up", "up", "up", "up");
        assertThat(states()).isEqualTo("(F4, F4)");
        assertThat(top.outcome()).hasToString("HANDLED");
        assertThat(converter.history()).hasSize(1);
    }

    @ParameterizedTest
    @EnumSource(OnFailure.class)
    void aShadowOfTheSameModelsFailsInTheSameSteps(OnFailure then) throws Exception {
        build(then, "F2 express", "F3 up");
        Shadow shadow = converter.shadow(Evolution.to(new Floors() {
            @Override
            void more() {
                onFailure(then);
            }
        }));
        press("top");
        broken.clear();
        press("top");
        assertThat(shadow.report().differences()).isEmpty();
        assertThat(shadow.report().at()).hasToString(states());
        assertThat(shadow.report().events()).isEqualTo(2);
    }

    @Test
    void whereThereIsNoOtherWayItSaysSo() throws Exception {
        build(OnFailure.OTHER_WAY, "F2 express", "F3 up");
        HistoryEntry top = press("top");
        assertThat(sent).containsExactly("up", "up", "up");
        assertThat(states()).isEqualTo("(F3, F0)");
        assertThat(top.outcome()).hasToString("FAILED");
        assertThat(reason(top)).contains("stuck at F3; no other way leads from F3 to F4");
    }

    @Test
    void whatIsSaidOfATransitionThatIsNotThereIsAProblem() {
        build(OnFailure.STAY);
        SystemEventConverter other = new SystemEventConverter(
                LoopConfig.defaults("other", new ManualClock()).withoutThreads());
        other.addExecute(new Lift());
        other.addKnowledge(new Floors() {
            @Override
            void more() {
                onFailure("F9", "top", OnFailure.GO_BACK);
            }
        });
        assertThatThrownBy(other::build)
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(
                        "it is said what follows when a plan for top in F9 breaks off, but the new model has no"
                                + " such transition");
        other.close();
    }
}
