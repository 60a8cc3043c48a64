"""The light bulb and the Roomba in the real Home Assistant; ./evoloop test --home-assistant runs this."""

from __future__ import annotations

import os
import signal
import tempfile
import time
import unittest
from pathlib import Path

from house import PROJECT, House

BROKER_RESTARTS = int(os.environ.get("EVOLOOP_BROKER_RESTARTS", "50"))
HOME_ASSISTANT_RESTARTS = int(os.environ.get("EVOLOOP_HOME_ASSISTANT_RESTARTS", "20"))
# Each service of a native entity, and what the entity then shows.
SERVICES: list[tuple[str, str, dict[str, str], str]] = [
    ("cover.open_cover", "cover.garage", {}, "opening"),
    ("cover.stop_cover", "cover.garage", {}, "open"),
    ("cover.close_cover", "cover.garage", {}, "closing"),
    ("climate.turn_on", "climate.air_conditioner", {}, "cool"),
    ("climate.set_preset_mode", "climate.air_conditioner", {"preset_mode": "boost"}, "cool"),
    ("climate.set_hvac_mode", "climate.air_conditioner", {"hvac_mode": "off"}, "off"),
    ("light.turn_on", "light.zigbee_bulb", {"effect": "both"}, "on"),
    ("light.turn_off", "light.zigbee_bulb", {}, "off"),
    ("fan.turn_on", "fan.fan", {"preset_mode": "high"}, "on"),
    ("fan.turn_off", "fan.fan", {}, "off"),
    ("vacuum.start", "vacuum.valetudo", {}, "cleaning"),
    ("vacuum.pause", "vacuum.valetudo", {}, "paused"),
    ("vacuum.return_to_base", "vacuum.valetudo", {}, "returning"),
    ("vacuum.stop", "vacuum.valetudo", {}, "idle"),
    ("switch.turn_off", "switch.washing_machine_switch_plug", {}, "off"),
    ("switch.turn_on", "switch.washing_machine_switch_plug", {}, "on"),
]


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

    def test_3_the_entities_of_device_files_are_operated_by_their_own_services(self) -> None:
        self.house.start_device("garage", Path(__file__).with_name("garage.yaml"))
        for name in ("roller-shutter", "air-conditioner", "zigbee-bulb", "fan", "valetudo", "washing-machine"):
            self.house.start_device(name, PROJECT / f"devices/{name}/{name}.yaml")
        for action, entity, data, state in SERVICES:
            self.house.wait(entity, lambda: self.house.shown(entity) not in ("", "unavailable"))
            self.house.call(action, entity, **data)
            self.house.wait_shown(entity, state)
        # Its child lock is not there, so it is locked.
        self.house.call("cover.open_cover", "cover.roller_shutter")
        self.house.wait("a failure", lambda: self.house.shown("event.roller_shutter_failure") not in ("", "unknown"))
        self.house.wait_shown("cover.roller_shutter", "closed")

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
