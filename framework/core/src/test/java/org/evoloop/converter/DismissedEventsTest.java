package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.Visit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Analyze and plan components that return null. */
class DismissedEventsTest {
    private boolean silent;

    private final EventAnalyze analyze = new EventAnalyze() {
        @Override
        protected @Nullable Analysis analyze(Occurrence occurrence) {
            return silent ? null : super.analyze(occurrence);
        }
    };

    @Test
    void aStateWhoseEventIsDismissedWhenItIsDecidedAgainIsEnteredAgainAtOnce() {
        List<Visit> visits = new ArrayList<>();
        try (Player player = new Player(visits::add, analyze)) {
            player.press("play");
            player.press("fade");
            player.settle();
            player.device.awaitReady = () -> {
                // The plan has ended the function, and is overtaken.
                player.acts("pause");
                silent = true;
            };
            player.press("stop");
            player.settle();

            assertThat(player.outcomes()).endsWith("pause IGNORED", "stop IGNORED");
            assertThat(player.states()).isEqualTo(at("Paused", "Fading"));
            assertThat(visits).hasSize(2);
            assertThat(visits.get(1).isActive()).isTrue();
        }
    }

    @Test
    void anAnalyzeComponentThatReturnsNullDoesNotKeepTheDeviceFromBeingAsked() {
        try (Player player = new Player(visit -> {}, analyze)) {
            assertAsked(player);
        }
    }

    @Test
    void neitherDoesAPlanComponent() {
        try (Player player = new Player(visit -> {})) {
            player.converter.exchange("EventPlan", new EventPlan("Silent") {
                @Override
                protected @Nullable ChangePlan plan(Analysis analysis) {
                    return silent ? null : super.plan(analysis);
                }
            });
            assertAsked(player);
        }
    }

    private void assertAsked(Player player) {
        player.device.canBeAsked = true;
        player.after = () -> {
            silent = true;
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
