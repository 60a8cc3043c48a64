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
    ("lock.unlock", "lock.door", {}, "unlocked"),
    ("lock.open", "lock.door", {}, "open"),
    ("lock.lock", "lock.door", {}, "locked"),
    ("button.press", "button.door_button_let_in", {}, ""),
    ("valve.open_valve", "valve.tap", {}, "opening"),
    ("valve.stop_valve", "valve.tap", {}, "open"),
    ("valve.close_valve", "valve.tap", {}, "closing"),
    ("select.select_option", "select.tap_select_water", {"option": "run"}, "run"),
    ("humidifier.turn_on", "humidifier.mist", {}, "on"),
    ("humidifier.set_mode", "humidifier.mist", {"mode": "high"}, "on"),
    ("humidifier.turn_off", "humidifier.mist", {}, "off"),
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
            self.house.wait_there(entity)
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

    def test_2_the_vacuum_is_operated(self) -> None:
        self.house.call("vacuum.start", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "cleaning")
        self.house.wait_shown("sensor.roomba_device_state", "Clean")
        self.house.call("vacuum.pause", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "paused")
        self.house.call("vacuum.stop", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "idle")
        self.house.call("vacuum.clean_spot", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "cleaning")
        self.house.call("vacuum.return_to_base", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "returning")
        self.house.call("vacuum.stop", "vacuum.roomba")
        self.house.wait_shown("vacuum.roomba", "idle")
        self.house.call("vacuum.locate", "vacuum.roomba")

    def test_3_the_schedule_and_the_quiet_hours_are_set(self) -> None:
        self.house.wait_shown("time.roomba_quiet_from", "22:00:00")
        self.house.call("time.set_value", "time.roomba_quiet_from", time="21:30:00")
        self.house.wait_shown("time.roomba_quiet_from", "21:30:00")
        self.house.call("text.set_value", "text.roomba_clean_at", value="SAT,SUN 10:00; 18:00")
        self.house.wait_shown("text.roomba_clean_at", "SAT,SUN 10:00; 18:00")
        self.house.call("switch.turn_on", "switch.roomba_skip_the_next")
        self.house.wait_shown("switch.roomba_skip_the_next", "on")
        self.house.wait("the next start", lambda: self.house.shown("sensor.roomba_next_start")[:2] == "20")
        self.house.call("switch.turn_off", "switch.roomba_schedule")
        self.house.wait_shown("switch.roomba_schedule", "off")
        self.house.wait_shown("sensor.roomba_next_start", "unknown")
        # What was set outlasts the program.
        self.house.stop("roomba")
        self.house.start_roomba()
        self.house.wait_shown("switch.roomba_schedule", "off")
        self.house.wait_shown("time.roomba_quiet_from", "21:30:00")

    def test_3_each_model_has_a_picture(self) -> None:
        for entity in ("image.lamp_picture", "image.roomba_picture", "image.roomba_picture_home"):
            self.house.wait(entity, lambda: self.house.shown(entity)[:2] == "20")

    def test_3_the_entities_of_device_files_are_operated_by_their_own_services(self) -> None:
        self.house.start_devices()
        for action, entity, data, state in SERVICES:
            if not entity.startswith("button."):
                self.house.wait_there(entity)
            self.house.call(action, entity, **data)
            if state:
                self.house.wait_shown(entity, state)
        # What the button and the modes have done.
        self.house.wait_shown("lock.door", "open")
        self.house.wait_there("event.door_event_movement")
        self.house.wait_shown("valve.tap", "opening")

    def test_3_what_has_failed_starts_an_automation(self) -> None:
        # Its child lock is not there, so it is locked.
        self.house.wait_there("cover.roller_shutter")
        self.house.call("cover.open_cover", "cover.roller_shutter")
        self.house.wait("an automation", lambda: "refused: " in self.house.newest.get("test/failed", ""))
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
