package org.evoloop.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Set;
import org.assertj.core.api.AbstractThrowableAssert;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** An adapter that keeps the order passes, and others fail. */
@Timeout(120)
class OrderCheckTest {
    private static void check(PlayerAdapter.Kind kind) {
        OrderCheck.of(Models.PLAYER)
                .buttons("play", "pause", "stop")
                .patience(Duration.ofSeconds(kind == PlayerAdapter.Kind.NO_FACTS ? 1 : 20))
                .check(line -> PlayerAdapter.of(kind, line));
    }

    private static AbstractThrowableAssert<?, ?> assertFails(PlayerAdapter.Kind kind) {
        return assertThatThrownBy(() -> check(kind)).isInstanceOf(AssertionError.class);
    }

    @Test
    void anAdapterThatReportsEverythingInOrderPasses() {
        check(PlayerAdapter.Kind.IN_ORDER);
    }

    @Test
    void anEffectThatIsReportedBeforeItHappensIsFound() {
        assertFails(PlayerAdapter.Kind.EFFECTS_TOO_SOON)
                .hasMessageMatching(
                        "(?s)the adapter does not keep the order when \\w+ is sent in \\w+, and the device does \\w+ "
                                + "by itself just before it takes \\w+: .*tookEffect.*It has reported:.*");
    }

    @Test
    void anActReportedAfterALaterEffectIsFound() {
        assertFails(PlayerAdapter.Kind.FACTS_TOO_LATE)
                .hasMessageContaining("the device reports ended, which is impossible in Paused");
    }

    @Test
    void anAdapterThatDoesNotSayWhatCameFirstLeavesTheConverterInDoubt() {
        assertFails(PlayerAdapter.Kind.NO_EFFECTS)
                .hasMessageContaining("it is unknown whether the device acted before or after");
    }

    @Test
    void anAdapterThatKeepsThingsToItselfIsFound() {
        assertFails(PlayerAdapter.Kind.NO_FACTS).hasMessageContaining("by itself");
    }

    @Test
    void everySituationInWhichTheOrderMattersIsPlayed() {
        assertThat(Situation.all(Models.PLAYER, Set.of("stop"), Set.of("play")))
                .extracting(Situation::toString)
                .as("the player is never paused, and play by hand before stop makes no difference")
                .containsExactly(
                        "when stop is sent in Playing, and the device does play by itself just after it takes stop");
    }

    @Test
    void aModelInWhichTheOrderNeverMattersCannotBeChecked() {
        StateMachine lamp = StateMachine.named("lamp")
                .initial("off")
                .transition("off", "switch", "on")
                .transition("on", "switch", "off")
                .build();
        assertThatThrownBy(() -> OrderCheck.of(lamp).check(line -> PlayerAdapter.of(PlayerAdapter.Kind.IN_ORDER, line)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("makes no difference; name all its own events by buttons");
    }

    @Test
    void anAdapterThatDoesNotListenIsRefused() {
        assertThatThrownBy(() -> OrderCheck.of(Models.PLAYER)
                        .buttons("play", "stop")
                        .check(line -> {
                            DeviceLine another = new DeviceLine(new DeviceModel(Models.PLAYER), () -> {});
                            DeviceAdapter adapter = PlayerAdapter.of(PlayerAdapter.Kind.IN_ORDER, another);
                            return new DeviceAdapter(adapter.monitor(), adapter.execute(), another::close);
                        }))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("the adapter does not listen to its line; call line.listen");
    }
}
