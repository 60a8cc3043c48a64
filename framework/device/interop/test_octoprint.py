"""OctoPrint with its virtual printer, operated by the converter of `devices/octoprint`."""

from __future__ import annotations

import json
import sys
import unittest
import urllib.request
from http.client import HTTPException
from pathlib import Path

from running import (
    Broker,
    Converter,
    Running,
    accepts,
    arrows,
    copied,
    free_port,
    learned,
    temporary,
    wait_until,
)

KEY = "0123456789ABCDEF0123456789ABCDEF"
SETTINGS = f"""
api: {{key: {KEY}}}
server: {{firstRun: false, onlineCheck: {{enabled: false}}, pluginBlacklist: {{enabled: false}}}}
serial: {{port: VIRTUAL, autoconnect: true, logPositionOnPause: false, logPositionOnCancel: false}}
plugins:
  virtual_printer: {{enabled: true}}
  _disabled: [softwareupdate, announcements, tracking, pluginmanager, discovery, backup, errortracking, achievements]
"""
DRAWN = {
    ("Ready", "start", "Printing"),
    ("Printing", "pause", "Paused"),
    ("Paused", "resume", "Printing"),
    ("Printing", "cancel", "Ready"),
    ("Paused", "cancel", "Ready"),
}
PRINT = "M140 S60\n" + "".join(f"G1 X{number % 100} F300\n" for number in range(20_000))


class OctoPrint(Running):
    def __init__(self, folder: Path) -> None:
        (folder / "octoprint").mkdir()
        settings = folder / "octoprint" / "config.yaml"
        settings.write_text(SETTINGS, encoding="utf-8")
        self._port = free_port()
        self.address = f"http://127.0.0.1:{self._port}"
        program = [Path(sys.executable).parent / "octoprint", "serve", "--iknowwhatimdoing", "--host", "127.0.0.1"]
        super().__init__([*program, "--port", str(self._port), "-b", settings.parent, "-c", settings], folder)
        wait_until("OctoPrint is there", lambda: accepts(self._port) and self._is_operational(), self.lines)

    def _is_operational(self) -> bool:
        try:
            return self.state() == "Operational"
        except (OSError, HTTPException):
            # While it starts, it answers in its own way, and with 409 until the printer is connected.
            return False

    def request(self, path: str, body: bytes | None = None, kind: str = "application/json") -> bytes:
        headers = {"X-Api-Key": KEY, "Content-Type": kind}
        with urllib.request.urlopen(urllib.request.Request(self.address + path, body, headers)) as answer:
            return answer.read()

    def state(self) -> str:
        return json.loads(self.request("/api/printer"))["state"]["text"]

    def bed(self) -> dict[str, float | None]:
        return json.loads(self.request("/api/printer"))["temperature"]["bed"]

    def select(self, gcode: str) -> None:
        parts = f'--X\r\nContent-Disposition: form-data; name="file"; filename="part.gcode"\r\n\r\n{gcode}\r\n'
        parts += '--X\r\nContent-Disposition: form-data; name="select"\r\n\r\ntrue\r\n--X--\r\n'
        self.request("/api/files/local", parts.encode(), "multipart/form-data; boundary=X")
        wait_until("it is selected", lambda: b"part.gcode" in self.request("/api/job"))

    def does(self, code: str) -> None:
        """Lets the virtual printer do something by itself."""
        self.request("/api/printer/command", json.dumps({"command": code}).encode())

    def wait_for(self, state: str) -> None:
        wait_until(f"OctoPrint is {state}", lambda: self.state() == state, lambda: (self.state(), self.bed()))


class OctoPrintTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = temporary()
        self.addCleanup(folder.cleanup)
        place = Path(folder.name)
        self.octoprint = OctoPrint(place)
        self.addCleanup(self.octoprint.close)
        broker = Broker(place)
        self.addCleanup(broker.close)
        (place / "key.txt").write_text(KEY, encoding="utf-8")
        self.place = place
        self.replaced = {
            "http://octopi.local": self.octoprint.address,
            "mqtt://127.0.0.1": f"mqtt://127.0.0.1:{broker.port}",
            "# header-files": "header-files",
            "every: 1 s": "every: 200 ms",
            "every: 5 s": "every: 500 ms",
        }
        self.octoprint.select(PRINT)

    def print(self, patience: str = "30 min") -> Converter:
        converter = Converter("octoprint", self.place, {**self.replaced, "after 30 min": "after " + patience})
        self.addCleanup(converter.close)
        converter.wait_for("Ready, Ready")
        converter.type("press start")
        converter.wait_for("Printing, Printing")
        self.assertEqual(self.octoprint.state(), "Printing")
        wait_until("the bed is warm", lambda: (self.octoprint.bed()["actual"] or 0) > 57, self.octoprint.bed)
        return converter

    def test_it_rests_until_the_bed_is_cool_and_goes_on_when_it_is_warm(self) -> None:
        converter = self.print()
        converter.type("press rest")
        self.octoprint.wait_for("Paused")
        converter.wait_for("Paused, Waiting")
        self.assertEqual(self.octoprint.bed()["target"], 0)
        self.assertLess(self.octoprint.bed()["actual"], 35)
        converter.type("press go_on")
        converter.wait_for("Printing, Printing")
        self.octoprint.wait_for("Printing")
        self.assertEqual(self.octoprint.bed()["target"], 60)
        self.assertGreater(self.octoprint.bed()["actual"], 55)

    def test_without_filament_and_without_an_answer_it_stops(self) -> None:
        converter = self.print(patience="5 s")
        self.octoprint.does("!!DEBUG:action_pause")
        converter.wait_for("Paused, Waiting")
        converter.wait_for("Ready, Ready")
        self.octoprint.wait_for("Operational")
        self.assertEqual(self.octoprint.bed()["target"], 0)

    def test_what_is_learned_is_what_its_readme_draws(self) -> None:
        model = self.place / "learned.mmd"
        file = copied("octoprint", self.place, {**self.replaced, "settle: 3 s": "settle: 1 s"})
        printed = learned(file, model, "--longest", "2 s")
        # A pause in a pause is accepted, too, and changes nothing.
        self.assertEqual({arrow for arrow in arrows(model) if arrow[0] != arrow[2]}, DRAWN)
        self.assertIn("tested to depth 1", printed)
        self.octoprint.wait_for("Operational")

    def test_what_is_done_on_its_page_is_followed(self) -> None:
        converter = self.print()
        self.octoprint.request("/api/job", b'{"command": "cancel"}')
        converter.wait_for("Ready, Ready")
        self.octoprint.wait_for("Operational")
        self.octoprint.request("/api/job", b'{"command": "start"}')
        converter.wait_for("Printing, Printing")


if __name__ == "__main__":
    unittest.main()
