package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.time.LocalTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.function.Function;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Analyze components with additional rules. */
class ChildLockTest {
    private static final LocalTime NIGHT = LocalTime.of(22, 0);
    private static final LocalTime MORNING = LocalTime.of(6, 0);

    /** Refuses the controller's events from 22:00 to 06:00; the converter cannot lock the device's own buttons. */
    private static final class ChildLock extends EventAnalyze {
        private @Nullable Clock clock;

        @Override
        protected @Nullable Analysis analyze(Occurrence occurrence) {
            return isNight() && occurrence.source().isButton() && !occurrence.isFact()
                    ? refuse(occurrence, "child lock from 22:00 to 06:00")
                    : super.analyze(occurrence);
        }

        private boolean isNight() {
            Clock known = clock;
            LocalTime now = known == null
                    ? LocalTime.NOON
                    : known.wallTime().atZone(ZoneOffset.UTC).toLocalTime();
            return now.isBefore(MORNING) || !now.isBefore(NIGHT);
        }
    }

    @Test
    void refusesTheControllerAtNightAndSaysWhy() {
        ChildLock lock = new ChildLock();
        try (Player player = new Player(NewFunction.none(), lock)) {
            // A manual clock starts at midnight.
            lock.clock = player.clock;
            player.press("play");
            player.settle();
            assertThat(player.last().outcome()).isEqualTo(Outcome.IGNORED);
            assertThat(player.last().detail()).isEqualTo("child lock from 22:00 to 06:00");
            assertThat(player.sent).isEmpty();

            player.acts("play");
            player.settle();
            assertThat(player.states()).isEqualTo(at("Playing", "Playing"));

            player.clock.advance(java.time.Duration.ofHours(7));
            player.press("stop");
            player.settle();
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        }
    }

    @Test
    void theHistoryOfARefusedFactTellsWhereTheDeviceWasBefore() {
        EventAnalyze lock = new EventAnalyze() {
            @Override
            protected Analysis analyze(Occurrence occurrence) {
                return refuse(occurrence, "locked");
            }
        };
        try (Player player = new Player(NewFunction.none(), lock)) {
            player.acts("play");
            player.settle();
            assertThat(player.last().before()).isEqualTo(at("Stopped", "Stopped"));
            assertThat(player.last().after()).isEqualTo(at("Playing", "Stopped"));
            assertThat(player.last().outcome()).isEqualTo(Outcome.IGNORED);
            assertThat(player.last().detail()).isEqualTo("locked");
        }
    }

    @Test
    void anAnalysisOfAnotherOccurrenceFailsInsteadOfBeingCarriedOut() {
        Occurrence[] first = new Occurrence[1];
        EventAnalyze forgetful = new EventAnalyze() {
            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                Analysis analysis = super.analyze(occurrence);
                first[0] = first[0] == null ? occurrence : first[0];
                return analysis == null ? null : new Analysis(first[0], analysis.decision());
            }
        };
        try (Player player = new Player(NewFunction.none(), forgetful)) {
            player.press("play");
            player.settle();
            player.press("play");
            player.settle();
            assertThat(player.last().outcome()).isEqualTo(Outcome.FAILED);
            assertThat(player.last().detail()).contains("the plan is for play").contains("not in the loop");
        }
    }

    @Test
    void aDecisionMadeForAnotherPlaceIsNeverCarriedOut() {
        EventAnalyze stubborn = new EventAnalyze() {
            private @Nullable Decision kept;

            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                Analysis analysis = super.analyze(occurrence);
                kept = kept == null && analysis != null ? analysis.decision() : kept;
                return analysis == null || kept == null ? null : new Analysis(occurrence, kept);
            }
        };
        try (Player player = new Player(NewFunction.none(), stubborn)) {
            player.press("play");
            player.settle();
            player.press("stop");
            player.settle();
            assertThat(player.sent).containsExactly("play");
            assertThat(player.last().outcome()).isEqualTo(Outcome.FAILED);
            assertThat(player.states()).isEqualTo(at("Playing", "Playing"));
        }
    }

    @Test
    void aLockOnEverythingDoesNotKeepTheDeviceFromBeingAskedWhereItIs() {
        EventAnalyze lock = new EventAnalyze() {
            private boolean locked;

            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                boolean refused = locked;
                locked = true;
                return refused ? refuse(occurrence, "locked") : super.analyze(occurrence);
            }
        };
        try (Player player = new Player(NewFunction.none(), lock)) {
            player.device.canBeAsked = true;
            player.after = () -> {
                throw new UnknownEffectException("play was not answered");
            };
            player.press("play");
            player.press("stop");
            player.settle();
            assertThat(player.outcomes()).containsExactly("play FAILED", "in doubt HANDLED", "stop IGNORED");
            assertThat(player.doubt()).isEmpty();
            assertThat(player.states()).isEqualTo(at("Playing", "Playing"));
        }
    }

    @Test
    void aDecisionThatLeadsToAStateThatDoesNotExistFails() {
        EventAnalyze inventive = new EventAnalyze() {
            @Override
            protected Analysis analyze(Occurrence occurrence) {
                Configuration here = configuration();
                State nowhere = new State("Plaing");
                Transition invented = new Transition(here.evolved(), new Event("play"), nowhere);
                return new Analysis(
                        occurrence,
                        new Decision.NewState(here, here.withEvolved(nowhere), List.of(), invented, List.of()));
            }
        };
        try (Player player = new Player(NewFunction.none(), inventive)) {
            player.press("play");
            player.settle();
            assertThat(player.last().outcome()).isEqualTo(Outcome.FAILED);
            assertThat(player.last().detail())
                    .contains("the plan leads to Plaing, which is not a state of the new model")
                    .contains("Playing");
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        }
    }

    @Test
    void aRefinedDecisionLeadsElsewhereOverDrawnTransitions() {
        EventAnalyze gentle = new EventAnalyze() {
            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                return occurrence.label().equals("stop")
                        ? new Analysis(occurrence, fading(configuration()))
                        : super.analyze(occurrence);
            }

            private Decision fading(Configuration here) {
                Transition fade = Player.MODELS
                        .evolved()
                        .transition(here.evolved(), new Event("fade"))
                        .orElseThrow();
                return new Decision.NewState(here, here.withEvolved(fade.target()), List.of(), fade, List.of());
            }
        };
        try (Player player = new Player(visit -> visit.finish("faded"), gentle)) {
            player.press("play");
            player.press("stop");
            player.settle();
            assertThat(player.outcomes()).containsExactly("play HANDLED", "stop HANDLED", "faded HANDLED");
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        }
    }

    @Test
    void aRefinedDecisionOverATransitionThatIsNotDrawnFails() {
        EventAnalyze inventive = new EventAnalyze() {
            @Override
            protected Analysis analyze(Occurrence occurrence) {
                Configuration here = configuration();
                State paused = new State("Paused");
                Transition invented = new Transition(here.evolved(), new Event("play"), paused);
                return new Analysis(
                        occurrence,
                        new Decision.ExistingState(here, at("Paused", "Paused"), List.of(), invented, List.of()));
            }
        };
        try (Player player = new Player(NewFunction.none(), inventive)) {
            player.press("play");
            player.settle();
            assertThat(player.last().detail())
                    .contains("the plan takes Stopped --play--> Paused, which is not a transition of the new model");
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        }
    }

    @Test
    void aRefinedDecisionThatLeadsElsewhereThanItSaysFails() {
        State stopped = new State("Stopped");
        Transition play =
                Player.MODELS.evolved().transition(stopped, new Event("play")).orElseThrow();
        assertRefused(
                here -> new Decision.ExistingState(here, at("Playing", "Playing"), List.of(), play, List.of()),
                "the plan leads the device from Stopped to Playing, but its steps [] lead to Stopped");
        assertRefused(
                here -> new Decision.ExistingState(here, at("Stopped", "Playing"), List.of(), play, List.of()),
                "the plan leads the new model to Playing and leaves the device in Stopped");
        assertRefused(
                here -> new Decision.NewState(here, at("Stopped", "Fading"), List.of(), play, List.of()),
                "the plan leads the new model from Stopped to Fading, but takes Stopped --play--> Playing");
        assertRefused(
                here -> new Decision.NotAcceptable(here, at("Stopped", "Fading"), List.of()),
                "the plan leads the new model from Stopped to Fading, but takes no transition");
    }

    private static void assertRefused(Function<Configuration, Decision> refined, String reason) {
        EventAnalyze mistaken = new EventAnalyze() {
            @Override
            protected Analysis analyze(Occurrence occurrence) {
                return new Analysis(occurrence, refined.apply(configuration()));
            }
        };
        try (Player player = new Player(NewFunction.none(), mistaken)) {
            player.press("play");
            player.settle();
            assertThat(player.last().outcome()).isEqualTo(Outcome.FAILED);
            assertThat(player.last().detail()).contains(reason);
            assertThat(player.sent).isEmpty();
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        }
    }
}
