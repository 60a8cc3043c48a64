package org.evoloop.fleet.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.engine.Output;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** A device of the fleet with a new state that needs it somewhere. */
class NeedingDeviceTest implements DeviceListener {
    private static final long SECOND = 1_000_000_000L;
    private static final List<ModelRecord> FANS = List.of(Models.FAN, Models.FAN_IN_CODE);

    private final List<Order> orders = new ArrayList<>();
    private String published = "";

    @Override
    public void ordered(Order order) {
        orders.add(order);
    }

    @Override
    public void noted(Output.Notice notice) {}

    @Override
    public void settled(DeviceState state, boolean isNew) {
        published = Wire.text(Wire.state(state, isNew));
    }

    @ParameterizedTest
    @FieldSource("FANS")
    void itsFunctionIsToRunOnceTheDeviceIsThereForCertain(ModelRecord fan) {
        Device device = new Device(ModelRecord.read("fan", fan.bytes()), 30 * SECOND, this, SECOND);
        device.observed(new Occurrence.Heard(new Event("boost"), Values.NONE, Source.CONTROLLER, 0, 2 * SECOND));
        sent(device, 1, 3 * SECOND);
        assertThat(published).contains("\"device\":\"Low\",\"system\":\"Off\"", "\"function\":false");
        sent(device, 2, 4 * SECOND);
        assertThat(published).contains("\"device\":\"High\",\"system\":\"Boost\",\"visit\":2,\"function\":true");
        // Nobody answers the command at the boost's end, and until the device says where it is, nothing is certain.
        device.due(14 * SECOND);
        device.due(14 * SECOND + 60 * SECOND);
        assertThat(published).contains("\"system\":\"Boost\",\"visit\":3,\"function\":false", "inDoubt");
        assertThat(orders).extracting(Order::kind).last().isEqualTo(Order.Kind.LOCATE);
        device.answered(new Answer(4, Answer.Outcome.SENT, "", new State("High"), 75 * SECOND));
        assertThat(published)
                .contains("\"system\":\"Boost\",\"visit\":3,\"function\":true")
                .doesNotContain("inDoubt");
        assertThat(orders).extracting(Order::what).containsExactly("power", "power", "power", "");
    }

    private static void sent(Device device, long sequence, long atNanos) {
        device.answered(new Answer(sequence, Answer.Outcome.SENT, "", null, atNanos));
    }

    @Test
    void whoDoesNotKnowWhatAProgramDeclaresRefusesIt() {
        assertThat(Wire.text(Models.FAN.bytes())).startsWith("{\"schema\":1,").doesNotContain("uses");
        assertThat(Wire.text(Models.FAN_IN_CODE.bytes())).startsWith("{\"schema\":2,");
        assertThatThrownBy(() -> Reading.of(Models.FAN_IN_CODE.bytes()))
                .isInstanceOf(Refusal.class)
                .hasMessage("its schema is 2, this program supports 1; update it first");
    }

    @Test
    void aDeclarationThatCannotBeIsOneMessage() {
        wrong(new ModelRecord.Use("Bost", "High", List.of()), "no state Bost that could need", "did you mean Boost?");
        wrong(new ModelRecord.Use("Boost", "Low", List.of()), "two device states, High and Low; keep one");
        wrong(new ModelRecord.Use("Boost", "", List.of("powr")), "is to send powr", "did you mean power?");
        wrong(new ModelRecord.Use("Low", "High", List.of()), "Low", "High");
    }

    private static void wrong(ModelRecord.Use use, String... parts) {
        ModelRecord fan = Models.FAN;
        ModelRecord declared = new ModelRecord(
                fan.file(), fan.text(), fan.original(), fan.evolved(), List.of(), List.of(use), ModelRecord.QUEUE);
        assertThatThrownBy(() -> ModelRecord.read("fan", declared.bytes()))
                .isInstanceOf(Refusal.class)
                .hasMessageStartingWith("models fan: ")
                .hasMessageContainingAll(parts);
    }
}
