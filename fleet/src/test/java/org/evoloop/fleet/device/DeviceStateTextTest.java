package org.evoloop.fleet.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.evoloop.core.Output;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** A device's state is the same after writing and reading it, whatever is in progress. */
class DeviceStateTextTest {
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
        byte[] text = DeviceStateText.write(device.state());
        assertThat(DeviceStateText.model(text)).isEqualTo("lamp-1");
        assertThat(DeviceStateText.read(lamp.rules(), text)).isEqualTo(device.state());
    }

    @Test
    void otherTextsAreRejected() {
        assertThatThrownBy(() -> DeviceStateText.model("nothing\n".getBytes(StandardCharsets.UTF_8)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("evoloop-device 1");
        byte[] text = DeviceStateText.write(device.state());
        String damaged = new String(text, StandardCharsets.UTF_8).replace("none", "nine");
        assertThatThrownBy(() -> DeviceStateText.read(lamp.rules(), damaged.getBytes(StandardCharsets.UTF_8)))
                .isInstanceOf(RuntimeException.class);
    }
}
