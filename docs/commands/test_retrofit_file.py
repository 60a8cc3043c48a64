"""Follows docs/retrofit-file.md to its end: from an empty folder to Home Assistant, without Java."""

from __future__ import annotations

import re
import subprocess
import unittest

from test_commands import BUILDS_PROJECTS, ROOT
from test_retrofit import PATIENCE_S, TOOL, FanCase, documented, published, until

GUIDE = (ROOT / "docs" / "retrofit-file.md").read_text(encoding="utf-8")
RUN = "./evoloop run my-fan/my-fan.yaml --start --name my-fan --journal my-fan/journal"


@unittest.skipUnless(BUILDS_PROJECTS, "slow: ./evoloop test --slow runs it")
class RetrofitFileTest(FanCase):
    def java(self, command: str) -> list[str]:
        """The documented command as ./evoloop runs it."""
        _, name, *words = documented(command, GUIDE)
        tool = ["java", "-cp", str(TOOL)]
        return [*tool, "org.evoloop.service.Ctl", *words] if name == "ctl" else [*tool, "org.evoloop.models.Main", "device", name, *words]

    def done(self, command: list[str]) -> str:
        ended = subprocess.run(command, cwd=self.folder, env=self.environment, capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        return ended.stdout

    def ctl(self, command: str) -> str:
        line = self.java(f"./evoloop ctl my-fan {command}")
        return subprocess.run(line, env=self.environment, capture_output=True, text=True, timeout=PATIENCE_S).stdout

    def begin_a_folder(self) -> None:
        new = self.java("./evoloop new my-fan --connection lines --address tcp://127.0.0.1:4001 --events power,speed")
        self.assertIn("wrote my-fan/my-fan.yaml", self.done(new))
        (sentence,) = [line for line in GUIDE.splitlines() if line.startswith("Type `start`, `press power`")]
        shown = {"start": "running: original Off", "press power": "new_current_state: On", "history": "(Off, Off) -> (On, On)", "exit": ""}
        self.assertEqual(re.findall("`(.*?)`", sentence), list(shown))
        simulated = self.begin(self.java("./evoloop run my-fan/my-fan.yaml --simulate"), cwd=self.folder, stdin=subprocess.PIPE)
        for typed, expected in shown.items():
            self.type(simulated, typed)
            until(f"{typed} shows {expected}", lambda: expected in self.said(simulated))
        self.assertEqual(simulated.wait(timeout=PATIENCE_S), 0, self.said(simulated))

    @staticmethod
    def type(process: subprocess.Popen[str], line: str) -> None:
        assert process.stdin
        process.stdin.write(f"{line}\n")
        process.stdin.flush()

    def replace_its_files(self) -> None:
        (drawings,) = re.findall(r"^````markdown\n(.*?)^````$", GUIDE, re.MULTILINE | re.DOTALL)
        (file,) = re.findall(r"^```yaml\n(.*?)^```$", GUIDE, re.MULTILINE | re.DOTALL)
        (self.folder / "my-fan" / "README.md").write_text(drawings, encoding="utf-8")
        (self.folder / "my-fan" / "my-fan.yaml").write_text(file.replace("4001", str(self.port)), encoding="utf-8")

    def test_the_guide_leads_from_an_empty_folder_to_home_assistant(self) -> None:
        self.begin_a_folder()
        self.replace_its_files()
        checked = self.done(self.java("./evoloop check my-fan/my-fan.yaml"))
        self.assertEqual(len(re.findall("^passed: ", checked, re.MULTILINE)), 2, checked)

        mqtt = self.begin_broker()
        fan = self.begin_fan()
        command = self.java(f"{RUN} --mqtt mqtt://localhost")
        self.assertEqual(command[:-2], self.java(RUN))
        command[-1] += f":{mqtt}"
        converter = self.begin(command, cwd=self.folder, stdin=subprocess.DEVNULL)
        until("the converter runs", lambda: "my-fan, running" in self.ctl("status"))
        until("the fan is connected", lambda: "connected" in self.said(fan))

        self.press(fan, "boost", "High")
        self.press(fan, "overheat", "Off")
        until("the converter knows", lambda: "original Off" in self.ctl("status"))
        self.ctl("press boost")
        until("boost leads to High", lambda: self.said(fan).strip().endswith("the fan is High"))
        self.press_breeze(fan)
        self.assertIn('"boost"', published(mqtt, "homeassistant/device/#"))

        self.end(fan)
        fan = self.begin_fan()
        until("the fan is connected again", lambda: "connected" in self.said(fan))
        self.press(fan, "boost", "High")
        self.ctl("exit")
        self.assertEqual(converter.wait(timeout=PATIENCE_S), 0, self.said(converter))

    def press_breeze(self, fan: subprocess.Popen[str]) -> None:
        self.type(fan, "breeze")
        until("the breeze begins", lambda: "Breeze" in self.ctl("status"))


if __name__ == "__main__":
    unittest.main()
