"""What the tests of all clients share: a robot for each test, and how it must move when it is told to."""

from __future__ import annotations

import math
import unittest

from simulated_roomba import SimulatedRoomba, State

BATTERY_PERCENT = 50
VOLTAGE_MILLI_VOLTS = 14_800
"""Of the half-full battery, in the middle of its 13.2 to 16.4 V."""
VOLTAGE_TOLERANCE_MILLI_VOLTS = 20

MM_PER_COUNT = math.pi * 72.0 / 508.8
"""Of a wheel's encoder (specification, "Left Encoder Counts")."""

WHEEL_BASE_MM = 235.0

SPEED_STEP_MM_PER_S = 28.5
"""The wheels know no speeds between (specification, "Drive"), so what they do is off by up to half of it."""

TICK_MILLIS = 15
SPEEDING_UP_MILLIS = 100

PRESS_MILLIS = 1500
"""Far longer than a client needs to ask."""

WALLED_ROOM = "wall 0 0 4000 4000\nstart 2000 2000 0\n"
BEFORE_RIGHT_BUMP = (3700, 2000, 40)
BEFORE_LEFT_BUMP = (3700, 2000, -40)
"""X, Y and heading short of a wall, which a robot that drives on meets with that side of its bumper."""

MODES = {"off": 0, "passive": 1, "safe": 2, "full": 3}


class InteropCase(unittest.TestCase):
    """A simulated robot, new for each test."""

    roomba: SimulatedRoomba

    def setUp(self) -> None:
        self.roomba = SimulatedRoomba(WALLED_ROOM, BATTERY_PERCENT)
        self.addCleanup(self.roomba.close)

    def wait_for_mode(self, mode: str) -> State:
        return self.roomba.wait_until(f"its mode is {mode}", lambda state: state.oi_mode == mode)

    def wait_for_activity(self, activity: str) -> State:
        return self.roomba.wait_until(f"its activity is {activity}", lambda state: state.activity == activity)

    def wait_for_rest(self) -> State:
        return self.roomba.wait_until("its wheels rest", lambda state: state.is_at_rest)

    def assert_voltage(self, milli_volts: int) -> None:
        self.assertAlmostEqual(milli_volts, VOLTAGE_MILLI_VOLTS, delta=VOLTAGE_TOLERANCE_MILLI_VOLTS)

    def assert_drives(self, right_mm_per_s: float, left_mm_per_s: float) -> None:
        """The wheels turn as told, and in the next second of robot time the robot comes to where that leads."""

        def is_as_told(state: State) -> bool:
            return (
                abs(state.right_mm_per_s - right_mm_per_s) <= SPEED_STEP_MM_PER_S / 2
                and abs(state.left_mm_per_s - left_mm_per_s) <= SPEED_STEP_MM_PER_S / 2
            )

        self.roomba.place(2000, 2000, 30)
        self.roomba.wait_until(f"right wheel {right_mm_per_s}, left wheel {left_mm_per_s} mm/s", is_as_told)
        before = self.roomba.wait_millis(SPEEDING_UP_MILLIS)
        after = self.roomba.wait_millis(1000)
        self.assertTrue(is_as_told(after), after)

        seconds = (after.time_millis - before.time_millis) / 1000
        turned_rad = (before.right_mm_per_s - before.left_mm_per_s) / WHEEL_BASE_MM * seconds
        rolled_mm = (before.right_mm_per_s + before.left_mm_per_s) / 2 * seconds
        chord_mm = rolled_mm * math.sin(turned_rad / 2) / (turned_rad / 2) if turned_rad else rolled_mm
        course_rad = math.radians(before.heading_deg) + turned_rad / 2
        self.assertAlmostEqual(after.x_mm, before.x_mm + chord_mm * math.cos(course_rad), delta=2)
        self.assertAlmostEqual(after.y_mm, before.y_mm + chord_mm * math.sin(course_rad), delta=2)
        missed_deg = math.remainder(after.heading_deg - before.heading_deg - math.degrees(turned_rad), 360)
        self.assertAlmostEqual(missed_deg, 0, delta=0.5)


def travelled_mm(before: State, after: State) -> float:
    """As the crow flies."""
    return math.hypot(after.x_mm - before.x_mm, after.y_mm - before.y_mm)


def counts_between(earlier: int, later: int) -> int:
    """Encoders go round after 16 bits; whether they are read with a sign or without makes no difference here."""
    return (later - earlier + 0x8000) % 0x10000 - 0x8000
