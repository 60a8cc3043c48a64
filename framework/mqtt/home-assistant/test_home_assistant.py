"""The light bulb and the Roomba in the real Home Assistant; ./evoloop test --home-assistant runs this."""

from __future__ import annotations

import os
import signal
import tempfile
import time
import unittest
from pathlib import Path

from house import House

BROKER_RESTARTS = int(os.environ.get("EVOLOOP_BROKER_RESTARTS", "50"))
HOME_ASSISTANT_RESTARTS = int(os.environ.get("EVOLOOP_HOME_ASSISTANT_RESTARTS", "20"))


class HomeAssistantTest(unittest.TestCase):
    house: House

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        cls.house = House(Path(cls.folder.name))
        cls.addClassCleanup(cls.folder.cleanup)
        cls.addClassCleanup(cls.house.close)
        cls.house.start_home_assistant_twice()
        cls.house.start_programs()

    def test_1_both_are_shown_as_soon_as_they_are_there(self) -> None:
        for name, entity in (("lamp", "switch.lamp_converting"), ("roomba", "vacuum.roomba")):
            self.house.wait(name, lambda: self.house.newest.get(f"evoloop/{name}/availability") == "online")
            begun = time.monotonic()
            self.house.wait(entity, lambda: self.house.shown(entity) not in ("", "unavailable", "unknown"))
            print(f"{entity} was shown {time.monotonic() - begun:.2f} s after its converter was there")
        self.house.wait_shown("sensor.lamp_state", "off")
        self.house.wait_shown("sensor.roomba_device_state", "Off")

    def test_2_the_lamp_is_operated(self) -> None:
        begun = time.monotonic()
        self.house.call("button.press", "button.lamp_press_switch")
        self.house.wait_shown("sensor.lamp_state", "on")
        print(f"a button took {time.monotonic() - begun:.2f} s there and back")
        self.house.call("switch.turn_off", "switch.lamp_converting")
        self.house.wait_shown("switch.lamp_converting", "off")
        self.house.call("switch.turn_on", "switch.lamp_converting")
        self.house.wait_shown("switch.lamp_converting", "on")

    def test_3_the_vacuum_is_operated(self) -> None:
        self.house.call("vacuum.start", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "cleaning")
        self.house.wait_shown("sensor.roomba_device_state", "Clean")
        self.house.call("vacuum.pause", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "paused")
        self.house.call("vacuum.stop", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "idle")

    def test_4_no_state_is_lost_with_the_broker(self) -> None:
        for _ in range(BROKER_RESTARTS):
            self.house.stop_broker()
            self.house.start_broker()
            self.house.wait_shown("sensor.lamp_state", "on")
            self.house.wait_shown("vacuum.roomba", "idle")

    def test_5_no_state_is_lost_with_home_assistant(self) -> None:
        for _ in range(HOME_ASSISTANT_RESTARTS):
            self.house.stop("home-assistant")
            self.house.start_home_assistant()
            self.house.wait_shown("sensor.lamp_state", "on")
            self.house.wait_shown("vacuum.roomba", "idle")

    def test_6_who_is_killed_is_unavailable(self) -> None:
        self.house.stop("lamp", signal.SIGKILL)
        self.house.wait_shown("sensor.lamp_state", "unavailable")

    def test_7_home_assistant_has_nothing_against_any_of_it(self) -> None:
        self.assertEqual(self.house.warnings(), [])


if __name__ == "__main__":
    unittest.main()
