package org.evoloop.roomba.session.inference;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.Frames;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class CommandEffectTest {
    private static final Command SAFE = new Command.Safe();
    private static final Command SPOT = new Command.Spot();
    private static final SensorValues PASSIVE = Frames.resting(OiMode.PASSIVE);
    private static final SensorValues CONTROLLED = Frames.resting(OiMode.SAFE);
    private static final SensorValues LIFTED = PASSIVE.with(Packet.BUMPS_AND_WHEEL_DROPS, 0b1100);

    private final CommandEffect effect = new CommandEffect();
    private long nowNanos;

    private @Nullable Command frame(SensorValues values) {
        nowNanos += Frames.APART_NANOS;
        return update(values);
    }

    private @Nullable Command update(SensorValues values) {
        return effect.update(values, values.value(Packet.OI_MODE) == OiMode.SAFE.code(), nowNanos);
    }

    @Test
    void aCommandThatTakesControlIsObeyedWhenTheModeShowsIt() {
        effect.sending(SAFE);
        assertThat(effect.isAwaited()).isTrue();
        assertThat(frame(PASSIVE)).as("not yet in effect").isNull();
        assertThat(frame(CONTROLLED)).isSameAs(SAFE);
        assertThat(frame(CONTROLLED)).as("reported once").isNull();
        assertThat(effect.isAwaited()).isFalse();
        assertThat(effect.isOver()).isTrue();
    }

    @Test
    void aCommandThatEndsControlIsObeyedWhenTheModeShowsIt() {
        frame(CONTROLLED);
        effect.sending(SPOT);
        effect.sending(new DriveDirect(0, 0));
        assertThat(frame(CONTROLLED)).isNull();
        assertThat(frame(PASSIVE)).isSameAs(SPOT);
    }

    @Test
    void aRobotThatIsLiftedLeavesControlByItself() {
        frame(CONTROLLED);
        effect.sending(SPOT);
        assertThat(frame(LIFTED)).isNull();
        assertThat(effect.isAwaited()).as("no frame will show it any more").isFalse();
    }

    @Test
    void whatTheModeDoesNotShowIsNotAwaited() {
        frame(PASSIVE);
        effect.sending(SPOT);
        assertThat(effect.isAwaited()).isFalse();
        assertThat(effect.isOver()).isFalse();
        for (int count = 0; count < CommandEffect.SHOW_FRAMES; count++) {
            assertThat(frame(PASSIVE)).isNull();
        }
        assertThat(effect.isOver()).isTrue();
        assertThat(effect.isMissing()).isFalse();
    }

    @Test
    void controlThatDoesNotComeIsMissingUntilItDoes() {
        effect.sending(SAFE);
        for (int count = 0; count < CommandEffect.SHOW_FRAMES; count++) {
            assertThat(frame(PASSIVE)).isNull();
        }
        assertThat(effect.isAwaited()).isFalse();
        assertThat(effect.isMissing()).isTrue();
        assertThat(frame(CONTROLLED)).as("too late to be sure of the cause").isNull();
        assertThat(effect.isMissing()).isFalse();
    }

    @Test
    void framesThatComeAtOnceAreOlderThanTheCommand() {
        effect.sending(SAFE);
        for (int count = 0; count < 10 * CommandEffect.SHOW_FRAMES; count++) {
            assertThat(update(PASSIVE)).isNull();
        }
        assertThat(effect.isOver()).isFalse();
        assertThat(frame(CONTROLLED)).isSameAs(SAFE);
        assertThat(effect.isMissing()).isFalse();
    }
}
