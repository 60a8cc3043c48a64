"""Debian's lircd, which sends into a file: an air conditioner reads it, and a metering plug tells what that takes.

The converter of `devices/air-conditioner` operates them.
"""

from __future__ import annotations

import json
import threading
import unittest
from pathlib import Path

import paho.mqtt.client as mqtt

from running import LIMIT_S, POLL_S, Broker, Converter, Running, arrows, copied, learned, temporary, wait_until

REMOTE = Path(__file__).resolve().with_name("ac.lircd.conf")
EVENTS = {0x10AF8877: "power", 0x10AF48B7: "turbo"}
MODEL = {
    ("Off", "power"): "Cool",
    ("Cool", "power"): "Off",
    ("Cool", "turbo"): "Turbo",
    ("Turbo", "turbo"): "Cool",
    ("Turbo", "power"): "Off",
}
WATTS = {"Off": 1.4, "Cool": 540.0, "Turbo": 1180.5}
LEAD_US = 4000
"""Longer than any space within a code, and shorter than what is around it."""
ONE_US = 1000
BITS = 32


class Lircd(Running):
    def __init__(self, folder: Path) -> None:
        self.socket = folder / "lircd"
        self.sent = folder / "sent"
        self.sent.touch()
        driver = ["lircd", "--nodaemon", "--driver=file", f"--device={self.sent}", f"--output={self.socket}"]
        super().__init__([*driver, f"--pidfile={folder / 'pid'}", f"--logfile={folder / 'lirc.log'}", REMOTE], folder)
        wait_until("lircd is there", self.socket.exists, self.lines)


class AirConditioner:
    """It sees what lircd sends, unless somebody stands in front of it."""

    def __init__(self, sent: Path, broker: Broker) -> None:
        self.state = "Off"
        self.log: list[str] = []
        self.is_covered = False
        self._sent = sent
        self._seen = 0
        self.meter = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
        self.meter.on_message = lambda client, data, message: self._answer()
        self.meter.connect("127.0.0.1", broker.port)
        self.meter.subscribe("cmnd/ac/Status")
        self.meter.loop_start()
        self.meter.publish("tele/ac/LWT", "Online", retain=True)
        self.meter.publish("tele/ac/SENSOR", self._energy())
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._watch)
        self._thread.start()

    def _energy(self) -> str:
        return json.dumps({"ENERGY": {"Power": WATTS[self.state]}})

    def _answer(self) -> None:
        self.meter.publish("stat/ac/STATUS8", json.dumps({"StatusSNS": json.loads(self._energy())}))

    def _watch(self) -> None:
        while not self._ended.wait(POLL_S):
            codes = self._codes()
            for code in codes[self._seen :]:
                self._take(EVENTS[code])
            self._seen = len(codes)

    def _codes(self) -> list[int]:
        codes: list[int] = []
        bits: list[str] = []
        for line in self._sent.read_text(encoding="ascii").splitlines():
            kind, _, micros = line.partition(" ")
            if kind == "space" and int(micros) > LEAD_US:
                bits = []
            elif kind == "space":
                bits.append("1" if int(micros) > ONE_US else "0")
                if len(bits) == BITS:
                    codes.append(int("".join(bits), 2))
        return codes

    def _take(self, event: str) -> None:
        if self.is_covered:
            self.log.append(f"misses {event}")
            return
        self.log.append(event)
        self.state = MODEL.get((self.state, event), self.state)
        self.meter.publish("tele/ac/SENSOR", self._energy())

    def close(self) -> None:
        self._ended.set()
        self._thread.join(LIMIT_S)
        self.meter.disconnect()
        self.meter.loop_stop()


class LircTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = temporary()
        self.addCleanup(folder.cleanup)
        place = Path(folder.name)
        broker = Broker(place)
        self.addCleanup(broker.close)
        lircd = Lircd(place)
        self.addCleanup(lircd.close)
        self.conditioner = AirConditioner(lircd.sent, broker)
        self.addCleanup(self.conditioner.close)
        self.place = place
        self.replaced = {
            "/run/lirc/lircd": str(lircd.socket),
            "mqtt://127.0.0.1": f"mqtt://127.0.0.1:{broker.port}",
            "steady: 5 s": "steady: 300 ms",
            "within: 20 s": "within: 2 s",
            "after 10 min": "after 3 s",
            "settle: 20 s": "settle: 600 ms",
        }

    def convert(self) -> None:
        self.converter = Converter("air-conditioner", self.place, self.replaced)
        self.addCleanup(self.converter.close)
        self.converter.wait_for("Off, Off")

    def press(self, event: str, states: str) -> None:
        self.converter.type(f"press {event}")
        self.converter.wait_for(states)
        self.assertEqual(self.conditioner.state, states.partition(",")[0])

    def window(self, is_closed: bool) -> None:
        self.conditioner.meter.publish("zigbee2mqtt/window", json.dumps({"contact": is_closed}))

    def test_it_is_learned_from_what_it_takes(self) -> None:
        model = self.place / "learned.mmd"
        file = copied("air-conditioner", self.place, self.replaced)
        printed = learned(file, model, "--longest", "1 s")
        self.assertEqual(arrows(model), {(source, event, target) for (source, event), target in MODEL.items()})
        self.assertIn("tested to depth 1", printed)
        self.assertEqual(self.conditioner.state, "Off")

    def test_boost_ends_by_itself(self) -> None:
        self.convert()
        self.press("power", "Cool, Cool")
        self.press("boost", "Turbo, Boost")
        self.converter.wait_for("Cool, Cool")
        self.assertEqual(self.conditioner.log, ["power", "turbo", "turbo"])

    def test_it_is_off_while_a_window_is_open(self) -> None:
        self.convert()
        self.press("power", "Cool, Cool")
        self.window(is_closed=False)
        self.converter.wait_for("Off, Airing")
        self.window(is_closed=True)
        self.converter.wait_for("Cool, Cool")
        self.assertEqual(self.conditioner.state, "Cool")
        self.assertEqual(self.conditioner.log, ["power", "power", "power"])

    def test_what_it_did_not_see_is_not_taken_for_done(self) -> None:
        self.convert()
        self.conditioner.is_covered = True
        self.converter.type("press power")
        wait_until("it was sent", lambda: self.conditioner.log == ["misses power"])
        wait_until("that has failed", lambda: "failed" in self.converter.history(), self.converter.history)
        self.converter.wait_for("Off, Off")
        self.conditioner.is_covered = False
        self.press("power", "Cool, Cool")


if __name__ == "__main__":
    unittest.main()
