package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.Generate.enumValues;
import static org.quicktheories.generators.SourceDSL.integers;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.quicktheories.core.Gen;

class PacketTest {

    @Test
    void idsRunFrom7To58() {
        assertThat(Arrays.stream(Packet.values()).map(Packet::id))
                .containsExactlyElementsOf(IntStream.rangeClosed(7, 58).boxed().toList());
    }

    @ParameterizedTest
    @CsvSource({
        "GROUP_0, 0, 7, 26, 26",
        "GROUP_1, 1, 7, 16, 10",
        "GROUP_2, 2, 17, 20, 6",
        "GROUP_3, 3, 21, 26, 10",
        "GROUP_4, 4, 27, 34, 14",
        "GROUP_5, 5, 35, 42, 12",
        "GROUP_6, 6, 7, 42, 52",
        "GROUP_100, 100, 7, 58, 80",
        "GROUP_101, 101, 43, 58, 28",
        "GROUP_106, 106, 46, 51, 12",
        "GROUP_107, 107, 54, 58, 9"
    })
    void groupsHaveTheMembersAndSizesOfTheSpecification(PacketGroup group, int id, int first, int last, int size) {
        assertThat(group.id()).isEqualTo(id);
        assertThat(group.size()).isEqualTo(size);
        assertThat(group.members())
                .extracting(Packet::id)
                .containsExactlyElementsOf(
                        IntStream.rangeClosed(first, last).boxed().toList());
    }

    @ParameterizedTest
    @CsvSource({
        "BUTTONS, 11",
        "CHARGING_STATE, 16",
        "CHARGING_SOURCES, 39",
        "OI_MODE, 40",
        "LEFT_ENCODER, 52",
        "RIGHT_ENCODER, 54",
        "MAIN_BRUSH_CURRENT, 75",
        "SIDE_BRUSH_CURRENT, 77",
        "STASIS, 79"
    })
    void packetsStandInGroup100WhereOtherClientsFindThem(Packet packet, int offset) {
        byte[] bytes = SensorValues.encode(List.of(PacketGroup.GROUP_100), asked -> asked == packet ? 1 : 0);
        assertThat(bytes[offset + packet.size() - 1]).isEqualTo((byte) 1);
    }

    @Test
    void signedPacketsAreThoseOfTheSpecification() {
        assertThat(Arrays.stream(Packet.values()).filter(Packet::isSigned))
                .extracting(Packet::id)
                .containsExactly(19, 20, 23, 24, 39, 40, 41, 42, 43, 44, 54, 55, 56, 57);
    }

    @ParameterizedTest
    @EnumSource
    void documentedRangeFitsIntoTheBytes(Packet packet) {
        assertThat(packet.min()).isLessThan(packet.max());
        for (int value : new int[] {packet.min(), packet.max()}) {
            assertThat(SensorValues.of(List.of(packet), asked -> value).value(packet))
                    .isEqualTo(value);
        }
    }

    @Test
    void unitIsThatOfTheSpecificationOrEmpty() {
        assertThat(Packet.CURRENT.unit()).isEqualTo("mA");
        assertThat(Packet.BUTTONS.unit()).isEmpty();
    }

    @Test
    void idFindsItsPacketOrGroup() {
        for (int id = -1; id <= 256; id++) {
            int asked = id;
            assertThat(PacketId.of(id).isPresent())
                    .as("id %d", id)
                    .isEqualTo((id >= 0 && id <= 58) || id == 100 || id == 101 || id == 106 || id == 107);
            PacketId.of(id).ifPresent(found -> assertThat(found.id()).isEqualTo(asked));
        }
    }

    @Test
    void encodedThenDecodedIsTheSameValue() {
        Gen<Integer> anything = integers().between(-32768, 65535);
        qt().forAll(enumValues(Packet.class), anything).checkAssert((packet, number) -> {
            int value = fitting(packet, number);
            byte[] bytes = SensorValues.encode(List.of(packet), asked -> value);
            assertThat(bytes).hasSize(packet.size());
            assertThat(SensorValues.decode(List.of(packet), bytes).value(packet))
                    .isEqualTo(value);
        });
    }

    private static int fitting(Packet packet, int number) {
        if (packet.size() == 1) {
            return packet.isSigned() ? (byte) number : number & 0xFF;
        }
        return packet.isSigned() ? (short) number : number & 0xFFFF;
    }

    @ParameterizedTest
    @CsvSource({"OI_MODE, 256", "OI_MODE, -1", "CURRENT, 32768", "CURRENT, -32769", "VOLTAGE, 65536", "TEMPERATURE, 128"
    })
    void shouldNameThePacketWhenAValueDoesNotFit(Packet packet, int value) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SensorValues.encode(List.of(packet), asked -> value))
                .withMessageContaining("packet " + packet.id() + " (" + packet + ") is " + value);
    }
}
