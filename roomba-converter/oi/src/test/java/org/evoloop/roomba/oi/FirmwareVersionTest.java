package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class FirmwareVersionTest {

    @Test
    void isFoundInTheBootTextOfOlderAndNewerRobots() {
        assertThat(FirmwareVersion.find("battery-current-zero 258\r\nr3_robot/tags/release-3.2.6:4975 CLEAN"))
                .contains(new FirmwareVersion(3, 2, 6));
        assertThat(FirmwareVersion.find(
                        "\u00feRoomba by iRobot!\r\nstm32\r\nr3-robot/tags/release-stm32-3.7.7:6913 CLEAN"))
                .contains(new FirmwareVersion(3, 7, 7));
    }

    @Test
    void isNotFoundElsewhere() {
        assertThat(FirmwareVersion.find("")).isEmpty();
        assertThat(FirmwareVersion.find("bootloader rev: #x0001\r\n2007-05-14-1715-L"))
                .isEmpty();
        assertThat(FirmwareVersion.find("r3_robot/tags/release-3.2")).isEmpty();
        assertThat(FirmwareVersion.find("r3_robot/tags/release-3.2.99999999999"))
                .isEmpty();
    }

    @Test
    void isOrderedByNumberAndNotByText() {
        assertThat(new FirmwareVersion(3, 10, 0)).isGreaterThan(new FirmwareVersion(3, 4, 1));
        assertThat(new FirmwareVersion(3, 3, 0)).isGreaterThan(new FirmwareVersion(3, 2, 6));
        assertThat(new FirmwareVersion(3, 3, 1)).isGreaterThan(new FirmwareVersion(3, 3, 0));
        assertThat(new FirmwareVersion(3, 3, 0)).hasToString("3.3.0");
    }

    @Test
    void aVersionIsParsedFromTextAndNothingElseIs() {
        assertThat(FirmwareVersion.parse("3.2.6")).isEqualTo(new FirmwareVersion(3, 2, 6));
        for (String wrong : new String[] {"", "3.2", "3.2.6.1", "v3.2.6", "3.2.12345"}) {
            assertThatThrownBy(() -> FirmwareVersion.parse(wrong))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("'" + wrong + "' is not a firmware version; write one such as 3.2.6");
        }
    }
}
