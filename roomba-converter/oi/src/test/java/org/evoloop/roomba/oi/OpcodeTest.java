package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OpcodeTest {

    @Test
    void allOpcodesOfTheSpecificationAreThereAndNoOthers() {
        int[] codes = IntStream.of(7, 162, 163, 164, 165, 167, 168, 173).toArray();
        int[] expected = IntStream.concat(
                        Arrays.stream(codes), IntStream.rangeClosed(128, 150).filter(code -> code != 147))
                .sorted()
                .toArray();
        assertThat(Arrays.stream(Opcode.values()).mapToInt(Opcode::code).sorted())
                .containsExactly(Arrays.stream(expected).boxed().toArray(Integer[]::new));
    }

    @Test
    void everyRecordOfCommandHasExactlyOneOpcode() {
        assertThat(records(Command.class).toList())
                .containsExactlyInAnyOrderElementsOf(Arrays.stream(Opcode.values())
                        .<Class<?>>map(Opcode::type)
                        .toList());
    }

    private static Stream<Class<?>> records(Class<?> type) {
        return type.isRecord()
                ? Stream.of(type)
                : Arrays.stream(type.getPermittedSubclasses()).flatMap(OpcodeTest::records);
    }

    @ParameterizedTest
    @CsvSource({
        "0, 7 128 130 131 132 133 134 135 136 143 173",
        "1, 129 138 141 142 150 165",
        "2, 162",
        "3, 139 144 168",
        "4, 137 145 146 163 164",
        "15, 167"
    })
    void commandsOfFixedLengthEndWithTheirLastDataByte(int dataBytes, String codes) {
        for (String code : codes.split(" ", -1)) {
            byte[] zeros = new byte[1 + dataBytes];
            zeros[0] = (byte) Integer.parseInt(code);
            assertThat(Feeding.parse(Arrays.copyOf(zeros, dataBytes)))
                    .as("opcode %s, one byte short", code)
                    .isEmpty();
            assertThat(Feeding.parse(zeros)).as("opcode %s", code).hasSize(1);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "OFF, 7 128",
        "PASSIVE, 7 128 129 130 131 132 133 134 135 136 140 142 143 148 149 150 165 167 168 173",
        "SAFE, 7 128 129 130 131 132 133 134 135 136 137 138 139 140 141 142 143 144 145 146 148 149 150 162 163 164 165 167 168 173",
        "FULL, 7 128 129 130 131 132 133 134 135 136 137 138 139 140 141 142 143 144 145 146 148 149 150 162 163 164 165 167 168 173"
    })
    void isAcceptedInTheModesOfTheSpecification(OiMode mode, String codes) {
        assertThat(Arrays.stream(Opcode.values()).filter(opcode -> opcode.isAcceptedIn(mode)))
                .extracting(opcode -> Integer.toString(opcode.code()))
                .containsExactlyInAnyOrder(codes.split(" "));
    }
}
