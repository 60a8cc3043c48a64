package org.evoloop.roomba.simulator.robot;

import java.nio.charset.StandardCharsets;

/** What the robot prints when it starts anew; robots differ in all but the mark before the firmware's version. */
final class BootText {
    private static final String TEXT = """
            Soft reset!
            Roomba by iRobot!
            stm32
            battery-current-zero 258
            r3-robot/tags/release-stm32-3.7.7:6913 CLEAN
            """;

    private BootText() {}

    static byte[] bytes() {
        return TEXT.replace("\n", "\r\n").getBytes(StandardCharsets.US_ASCII);
    }
}
