package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.evoloop.roomba.oi.Feeding.octets;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.integers;
import static org.quicktheories.generators.SourceDSL.lists;

import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SensorValuesTest {

    private static SensorValues only(Packet packet, int value) {
        return SensorValues.of(List.of(packet), asked -> value);
    }

    @Test
    void replyOfSeveralPacketsIsReadInTheOrderAsked() {
        SensorValues values = SensorValues.decode(
                List.of(Packet.CURRENT, Packet.OI_MODE, PacketGroup.GROUP_2),
                octets(255, 56, 1, 9, 2, 255, 255, 0, 90));
        assertThat(values.currentMilliAmps()).isEqualTo(-200);
        assertThat(values.mode()).contains(OiMode.PASSIVE);
        assertThat(values.value(Packet.INFRARED_OMNI)).isEqualTo(9);
        assertThat(values.buttons()).containsExactly(Button.SPOT);
        assertThat(values.distanceMm()).isEqualTo(-1);
        assertThat(values.angleDegrees()).isEqualTo(90);
        assertThat(values.has(Packet.VOLTAGE)).isFalse();
    }

    @Test
    void randomBytesDecodedThenEncodedAreTheSameBytes() {
        qt().withExamples(300)
                .forAll(
                        lists().of(RandomCommands.packetIds())
                                .ofSizeBetween(1, 5)
                                .assuming(SensorValuesTest::disjoint),
                        integers().all())
                .checkAssert((packets, seed) -> {
                    byte[] bytes = Feeding.noise(new Random(seed), PacketId.size(packets));
                    SensorValues values = SensorValues.decode(packets, bytes);
                    assertThat(SensorValues.encode(packets, values::value)).containsExactly(bytes);
                });
    }

    private static boolean disjoint(List<PacketId> packets) {
        long members =
                packets.stream().mapToLong(packet -> packet.members().size()).sum();
        return members
                == packets.stream()
                        .flatMap(packet -> packet.members().stream())
                        .distinct()
                        .count();
    }

    @Test
    void sourceIsAskedOncePerPacketInOrder() {
        List<Packet> asked = new ArrayList<>();
        SensorValues.encode(List.of(Packet.ANGLE, PacketGroup.GROUP_2), packet -> {
            asked.add(packet);
            return 0;
        });
        assertThat(asked)
                .containsExactly(Packet.ANGLE, Packet.INFRARED_OMNI, Packet.BUTTONS, Packet.DISTANCE, Packet.ANGLE);
    }

    @Test
    void packetThatComesTwiceHasItsLastValue() {
        assertThat(SensorValues.decode(List.of(Packet.WALL, Packet.WALL), octets(1, 0))
                        .value(Packet.WALL))
                .isZero();
    }

    @Test
    void shouldSayHowManyBytesWhenTheReplyHasAnotherLength() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SensorValues.decode(List.of(Packet.CURRENT), octets(1)))
                .withMessage("reply to packets [CURRENT] is 1 bytes; allowed is 2 to 2 bytes");
    }

    @Test
    void shouldNameThePacketWhenItWasNotAskedFor() {
        assertThatExceptionOfType(NoSuchElementException.class)
                .isThrownBy(only(Packet.WALL, 1)::mode)
                .withMessage("packet 35 (OI_MODE) is not among the values {WALL=1}; ask for it");
    }

    @Test
    void codesThatTheSpecificationLacksStayRaw() {
        SensorValues mode = only(Packet.OI_MODE, 4);
        assertThat(mode.value(Packet.OI_MODE)).isEqualTo(4);
        assertThat(mode.mode()).isEmpty();
        assertThat(only(Packet.CHARGING_STATE, 6).chargingState()).isEmpty();
        assertThat(only(Packet.STASIS, 2).value(Packet.STASIS)).isEqualTo(2);
    }

    @Test
    void codesOfTheSpecificationHaveTheirNames() {
        for (OiMode mode : OiMode.values()) {
            assertThat(only(Packet.OI_MODE, mode.code()).mode()).contains(mode);
        }
        for (ChargingState state : ChargingState.values()) {
            assertThat(only(Packet.CHARGING_STATE, state.code()).chargingState())
                    .contains(state);
        }
        assertThat(OiMode.values()).extracting(OiMode::code).containsExactly(0, 1, 2, 3);
        assertThat(ChargingState.values()).extracting(ChargingState::code).containsExactly(0, 1, 2, 3, 4, 5);
        assertThat(Button.values()).extracting(Button::bit).containsExactly(0, 1, 2, 3, 4, 5, 6, 7);
    }

    @Test
    void eachGetterReadsItsOwnPacket() {
        SensorValues ids = SensorValues.of(List.of(PacketGroup.GROUP_100), Packet::id);
        assertThat(ids.distanceMm()).isEqualTo(19);
        assertThat(ids.angleDegrees()).isEqualTo(20);
        assertThat(ids.voltageMilliVolts()).isEqualTo(22);
        assertThat(ids.currentMilliAmps()).isEqualTo(23);
        assertThat(ids.batteryChargeMilliAmpHours()).isEqualTo(25);
        assertThat(ids.batteryCapacityMilliAmpHours()).isEqualTo(26);
        assertThat(ids.leftEncoderCounts()).isEqualTo(43);
        assertThat(ids.rightEncoderCounts()).isEqualTo(44);
        assertThat(ids.mainBrushMilliAmps()).isEqualTo(56);
        assertThat(ids.sideBrushMilliAmps()).isEqualTo(57);
    }

    @Test
    void pressedButtonsAndOvercurrentsHaveTheirBits() {
        assertThat(only(Packet.BUTTONS, 2).isPressed(Button.SPOT)).isTrue();
        assertThat(only(Packet.BUTTONS, 2).isPressed(Button.CLEAN)).isFalse();
        assertThat(only(Packet.OVERCURRENTS, 0).anyOvercurrent()).isFalse();
        assertThat(only(Packet.OVERCURRENTS, 16).anyOvercurrent()).isTrue();
    }

    @Test
    void eachBumpAndWheelDropHasItsBit() {
        assertThat(only(Packet.BUMPS_AND_WHEEL_DROPS, 1).bumpRight()).isTrue();
        assertThat(only(Packet.BUMPS_AND_WHEEL_DROPS, 2).bumpLeft()).isTrue();
        assertThat(only(Packet.BUMPS_AND_WHEEL_DROPS, 4).wheelDropRight()).isTrue();
        assertThat(only(Packet.BUMPS_AND_WHEEL_DROPS, 8).wheelDropLeft()).isTrue();
        assertThat(only(Packet.BUMPS_AND_WHEEL_DROPS, 3).anyWheelDrop()).isFalse();
        assertThat(only(Packet.BUMPS_AND_WHEEL_DROPS, 12).bumpRight()).isFalse();
    }

    @Test
    void eachChargingSourceHasItsBit() {
        assertThat(only(Packet.CHARGING_SOURCES, 1).onInternalCharger()).isTrue();
        assertThat(only(Packet.CHARGING_SOURCES, 1).onHomeBase()).isFalse();
        assertThat(only(Packet.CHARGING_SOURCES, 2).onHomeBase()).isTrue();
    }

    @Test
    void anyOfTheFourCliffSensorsCounts() {
        List<Packet> sensors =
                List.of(Packet.CLIFF_LEFT, Packet.CLIFF_FRONT_LEFT, Packet.CLIFF_FRONT_RIGHT, Packet.CLIFF_RIGHT);
        SensorValues none = SensorValues.of(sensors, sensor -> 0);
        assertThat(none.anyCliff()).isFalse();
        assertThat(sensors)
                .allSatisfy(
                        sensor -> assertThat(none.with(sensor, 1).anyCliff()).isTrue());
    }

    @Test
    void withAddsOrReplacesOneValueAndLeavesTheOriginal() {
        SensorValues original = only(Packet.OI_MODE, 3);
        SensorValues corrected = original.with(Packet.OI_MODE, 2).with(Packet.STASIS, 1);
        assertThat(corrected.mode()).contains(OiMode.SAFE);
        assertThat(corrected.value(Packet.STASIS)).isEqualTo(1);
        assertThat(original).isEqualTo(only(Packet.OI_MODE, 3)).isNotEqualTo(corrected);
        assertThat(original).hasSameHashCodeAs(only(Packet.OI_MODE, 3));
    }

    @Test
    void zeroIsNotTheSameAsAbsent() {
        assertThat(only(Packet.WALL, 0)).isNotEqualTo(only(Packet.VIRTUAL_WALL, 0));
    }

    @Test
    void encoderDeltaIsRightAcrossTheWrapInBothDirections() {
        assertThat(SensorValues.encoderDelta(32767, -32768)).isEqualTo(1);
        assertThat(SensorValues.encoderDelta(-32768, 32767)).isEqualTo(-1);
        assertThat(SensorValues.encoderDelta(100, 40)).isEqualTo(-60);
        assertThat(SensorValues.encoderDelta(65535, 0)).isEqualTo(1);
    }
}
