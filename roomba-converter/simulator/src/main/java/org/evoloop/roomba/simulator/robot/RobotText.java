package org.evoloop.roomba.simulator.robot;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.evoloop.roomba.oi.FirmwareVersion;
import org.evoloop.roomba.simulator.body.Body;

/**
 * Text for people that the robot prints between its replies. Only the marks that programs search for are the same on
 * all robots.
 */
final class RobotText {
    /** From this version on robots have another processor, and a boot text without a boot loader's part. */
    private static final FirmwareVersion FIRST_STM32 = new FirmwareVersion(3, 5, 0);

    private static final int SECONDS_PER_MINUTE = 60;
    private static final int CELSIUS_TENTHS = 10;

    private RobotText() {}

    /** Printed at a reset: the boot loader's text, or the last text of the program that ends. */
    static byte[] resetting(FirmwareVersion firmware) {
        return firmware.compareTo(FIRST_STM32) < 0 ? bytes("""
                        bl-start
                        STR730
                        bootloader rev: #x0001
                        """) : bytes("""
                        Soft reset!
                        """);
    }

    /** Printed when the program has started; on the newer processor the line is low at first, which reads as a byte. */
    static byte[] started(FirmwareVersion firmware) {
        return firmware.compareTo(FIRST_STM32) < 0 ? bytes("""
                        Roomba by iRobot!
                        str730
                        battery-current-zero 258
                        r3_robot/tags/release-%s:4975 CLEAN
                        """, firmware) : bytes("""
                        \u00feRoomba by iRobot!
                        stm32
                        battery-current-zero 258
                        r3-robot/tags/release-stm32-%s:6913 CLEAN
                        """, firmware);
    }

    /** Printed once a second while the robot charges. */
    static byte[] charging(Body body, long seconds) {
        return bytes(
                "bat:   min %d  sec %d  mV %d  mA %d  tenths-deg-C %d  mAH %d  state 5  \n",
                seconds / SECONDS_PER_MINUTE,
                seconds % SECONDS_PER_MINUTE,
                body.battery().milliVolts(),
                body.batteryMilliAmps(),
                Sensors.TEMPERATURE_CELSIUS * CELSIUS_TENTHS,
                body.battery().chargeMilliAmpHours());
    }

    /** Printed when the robot falls asleep. */
    static byte[] fallingAsleep() {
        return bytes("processor-sleep\n");
    }

    /** Printed when the robot wakes. */
    static byte[] waking(String waker, long sleptSeconds) {
        return bytes(
                "%s-wakeup\nslept for %d minutes %d seconds\n",
                waker, sleptSeconds / SECONDS_PER_MINUTE, sleptSeconds % SECONDS_PER_MINUTE);
    }

    private static byte[] bytes(String format, Object... values) {
        return String.format(Locale.ROOT, format, values).replace("\n", "\r\n").getBytes(StandardCharsets.ISO_8859_1);
    }
}
