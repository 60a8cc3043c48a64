"""A client that writes one byte at a time and pauses after each, like a slow microcontroller or a shell script."""

from __future__ import annotations

import time

from serial import Serial

from interop_case import MODES, TICK_MILLIS, InteropCase

PAUSE_S = 0.04
"""More than two of the robot's ticks."""

LONG_PAUSE_MILLIS = 1000

START, BAUD, SAFE, FULL, SPOT, CLEAN, STOP = 128, 129, 131, 132, 134, 135, 173
DRIVE, DRIVE_DIRECT, SONG, PLAY = 137, 145, 140, 141
SENSORS, STREAM, QUERY_LIST, PAUSE_STREAM = 142, 148, 149, 150
VOLTAGE_PACKET, MODE_PACKET = 22, 35
BAUD_19200 = 7


class ByteByByteTest(InteropCase):
    def setUp(self) -> None:
        super().setUp()
        self.serial = Serial(self.roomba.port, 115_200, timeout=2)
        self.addCleanup(self.serial.close)
        self.write(START)

    def write(self, *octets: int) -> None:
        for octet in octets:
            self.serial.write(bytes([octet]))
            time.sleep(PAUSE_S)

    def read_mode(self) -> int:
        self.write(SENSORS, MODE_PACKET)
        return self.serial.read(1)[0]

    def read_voltage(self) -> int:
        self.write(SENSORS, VOLTAGE_PACKET)
        return int.from_bytes(self.serial.read(2), "big")

    def test_modes_are_as_told(self) -> None:
        for opcode, mode in ((SAFE, "safe"), (FULL, "full"), (START, "passive")):
            with self.subTest(mode=mode):
                self.write(opcode)
                self.wait_for_mode(mode)
                self.assertEqual(self.read_mode(), MODES[mode])
        self.write(STOP)
        self.wait_for_mode("off")

    def test_it_drives_as_told(self) -> None:
        self.write(SAFE)
        for name, octets, right, left in (
            ("the specification's example", (DRIVE, 255, 56, 1, 244), -247, -153),
            ("straight", (DRIVE, 0, 200, 128, 0), 200, 200),
            ("straight in its other form", (DRIVE, 1, 44, 127, 255), 300, 300),
            ("spin clockwise", (DRIVE, 0, 114, 255, 255), -114, 114),
            ("spin counterclockwise", (DRIVE, 0, 114, 0, 1), 114, -114),
            ("direct", (DRIVE_DIRECT, 0, 228, 255, 142), 228, -114),
        ):
            with self.subTest(name):
                self.write(*octets)
                self.assert_drives(right, left)

    def test_half_a_command_waits_for_the_rest(self) -> None:
        self.write(SAFE, DRIVE_DIRECT, 0, 200)
        waiting = self.roomba.wait_millis(LONG_PAUSE_MILLIS)
        self.assertTrue(waiting.is_at_rest, waiting)
        self.write(0, 200)
        self.assert_drives(200, 200)

    def test_data_that_looks_like_commands_is_data(self) -> None:
        self.write(SAFE, SONG, 1, 2, STOP, CLEAN, SPOT, START, PLAY, 1)
        self.assertEqual(self.roomba.state().oi_mode, "safe")
        self.assertEqual(self.read_mode(), MODES["safe"])

    def test_queries_are_answered_in_the_order_asked(self) -> None:
        self.write(QUERY_LIST, 3, MODE_PACKET, VOLTAGE_PACKET, MODE_PACKET)
        answer = self.serial.read(4)
        self.assertEqual((answer[0], answer[3]), (MODES["passive"], MODES["passive"]))
        self.assert_voltage(int.from_bytes(answer[1:3], "big"))
        self.assertEqual(self.serial.in_waiting, 0)

    def test_every_frame_of_a_stream_is_good(self) -> None:
        self.write(STREAM, 2, 29, 13)
        for _ in range(200):
            frame = self.serial.read(8)
            self.assertEqual((*frame[:3], *frame[5:7]), (19, 5, 29, 13, 0))
            self.assertEqual(sum(frame) % 256, 0)

        self.write(PAUSE_STREAM, 0)
        self.roomba.wait_until("the stream pauses", lambda state: not state.streaming)
        self.roomba.wait_millis(2 * TICK_MILLIS)
        self.serial.reset_input_buffer()
        self.assert_voltage(self.read_voltage())
        self.write(PAUSE_STREAM, 1)
        self.assertEqual(tuple(self.serial.read(3)), (19, 5, 29))

    def test_cleaning_starts_and_pauses(self) -> None:
        for opcode, activity in ((CLEAN, "clean"), (SPOT, "spot")):
            with self.subTest(activity=activity):
                self.write(opcode)
                self.wait_for_activity(activity)
                self.write(opcode)
                self.wait_for_activity("on")

    def test_it_speaks_another_rate(self) -> None:
        self.write(BAUD, BAUD_19200)
        self.roomba.wait_until("its rate is 19200", lambda state: state.baud == 19_200)
        self.serial.baudrate = 19_200
        self.roomba.wait_millis(100)
        self.assert_voltage(self.read_voltage())

    def test_a_client_that_leaves_changes_nothing(self) -> None:
        self.write(SAFE, DRIVE_DIRECT, 0, 57, 255, 199)
        self.serial.close()
        self.assert_drives(57, -57)
        self.serial.open()
        self.assertEqual(self.read_mode(), MODES["safe"])
        self.write(START)
        self.wait_for_rest()
