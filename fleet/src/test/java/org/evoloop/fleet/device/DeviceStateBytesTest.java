package org.evoloop.fleet.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Set;
import org.evoloop.engine.Output;
import org.evoloop.engine.codec.CodecException;
import org.evoloop.engine.codec.SnapshotText;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** A device's state is the same after it was written and read, at any moment. */
class DeviceStateBytesTest {
    private static final long PATIENCE = 1_000_000_000L;

    private final Model lamp = ModelRecord.read("lamp-1", Models.LAMP.bytes());
    private final Device device = new Device(lamp, PATIENCE, new IgnoringListener(), 1);

    private static final class IgnoringListener implements DeviceListener {
        @Override
        public void ordered(Order order) {}

        @Override
        public void noted(Output.Notice notice) {}

        @Override
        public void settled(DeviceState state, boolean isNew) {}
    }

    @Test
    void readingReturnsWhatWasWritten() {
        assertUnchanged();
        press(10);
        assertThat(device.state().open()).isNotNull();
        assertUnchanged();
        device.answered(new Answer(1, Answer.Outcome.IN_DOUBT, "the line broke", null, 20));
        assertThat(device.state().lost()).isNotNull();
        assertThat(device.state().open().kind()).isEqualTo(Order.Kind.LOCATE);
        assertUnchanged();
        press(30);
        assertThat(device.isNews(5)).isTrue();
        assertThat(device.isNews(5)).isFalse();
        device.answered(new Answer(2, Answer.Outcome.SENT, "", new State("on"), 40));
        assertThat(device.state().heard()).isEqualTo(5);
        assertUnchanged();
    }

    private void press(long atNanos) {
        device.observed(new Occurrence.Heard(
                new Event("switch"), Values.of("a", "b c"), Source.PANEL, false, Set.of("x"), 0, atNanos));
    }

    private void assertUnchanged() {
        byte[] bytes = DeviceStateBytes.write(device.state());
        assertThat(bytes.length)
                .isLessThan(SnapshotText.write(device.state().snapshot()).length() / 2);
        assertThat(DeviceStateBytes.model(bytes)).isEqualTo("lamp-1");
        assertThat(DeviceStateBytes.read(version -> lamp.rules(), bytes)).isEqualTo(device.state());
    }

    @Test
    void whateverIsMissingIsNoticed() {
        press(10);
        byte[] bytes = DeviceStateBytes.write(device.state());
        for (int length = 0; length < bytes.length; length++) {
            byte[] part = Arrays.copyOf(bytes, length);
            assertThatThrownBy(() -> DeviceStateBytes.read(version -> lamp.rules(), part))
                    .isInstanceOf(CodecException.class);
        }
    }

    @Test
    void anotherVersionIsRefused() {
        byte[] bytes = DeviceStateBytes.write(device.state());
        bytes[0] = 2;
        assertThatThrownBy(() -> DeviceStateBytes.model(bytes))
                .isInstanceOf(CodecException.class)
                .hasMessageContaining("version 2 cannot be read, only version 3; use the version of Evoloop");
    }

    @Test
    void onlyTheNumbersOfARemovedDeviceAreKept() {
        byte[] bytes = DeviceStateBytes.write(new Past(7, -1));
        assertThat(DeviceStateBytes.isRemoved(bytes)).isTrue();
        assertThat(DeviceStateBytes.isRemoved(DeviceStateBytes.write(device.state())))
                .isFalse();
        assertThat(DeviceStateBytes.past(bytes)).isEqualTo(new Past(7, -1));
        assertThatThrownBy(() -> DeviceStateBytes.past(Arrays.copyOf(bytes, 2))).isInstanceOf(CodecException.class);
    }
}
