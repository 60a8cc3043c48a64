"""Shared by the tests of all clients: a robot for each test, and checks of its movements."""

from __future__ import annotations

import math
import unittest

from simulated_roomba import SimulatedRoomba, State

BATTERY_PERCENT = 50
VOLTAGE_MILLI_VOLTS = 14_800
"""The voltage of the half-full battery, in the middle of its 13.2 to 16.4 V."""
VOLTAGE_TOLERANCE_MILLI_VOLTS = 20

MM_PER_COUNT = math.pi * 72.0 / 508.8
"""The distance per count of a wheel's encoder (specification, "Left Encoder Counts")."""

WHEEL_BASE_MM = 235.0

SPEED_STEP_MM_PER_S = 28.5
"""The wheels' speeds are multiples of this (specification, "Drive"), so a speed is off by up to half of it."""

TICK_MILLIS = 15
SPEEDING_UP_MILLIS = 100

PRESS_MILLIS = 1500
"""Far longer than a client needs for a query."""

WALLED_ROOM = "wall 0 0 4000 4000\nstart 2000 2000 0\n"
BEFORE_RIGHT_BUMP = (3700, 2000, 40)
BEFORE_LEFT_BUMP = (3700, 2000, -40)
"""X, Y and heading in front of a wall, which a robot driving straight on hits with that side of its bumper."""

MODES = {"off": 0, "passive": 1, "safe": 2, "full": 3}


class InteropCase(unittest.TestCase):
    """A test with a new simulated robot."""

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
        """Asserts that the wheels turn as commanded, and the robot is where that leads after a second of robot time."""

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
    """The distance in a straight line."""
    return math.hypot(after.x_mm - before.x_mm, after.y_mm - before.y_mm)


def counts_between(earlier: int, later: int) -> int:
    """Encoders overflow after 16 bits; whether they are read as signed or unsigned makes no difference here."""
    return (later - earlier + 0x8000) % 0x10000 - 0x8000
