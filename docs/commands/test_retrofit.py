"""Follows docs/retrofit.md to its end, with the project that it makes, a fan, a broker, and a converter between them."""

from __future__ import annotations

import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from collections.abc import Callable
from pathlib import Path

from repository import SCAFFOLDED, Repository
from test_commands import BUILDS_PROJECTS, ROOT

GUIDE = (ROOT / "docs" / "retrofit.md").read_text(encoding="utf-8")
PATIENCE_S = 60
TOOL = ROOT / "framework" / "models" / "target" / "evoloop-models.jar"
BROKER = shutil.which("mosquitto") or "/usr/sbin/mosquitto"


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", GUIDE, re.MULTILINE | re.DOTALL)


def documented(command: str, guide: str = GUIDE) -> list[str]:
    """The words of a command that the guide has."""
    (line,) = [line.strip() for line in guide.splitlines() if line == f"    {command}"]
    return line.split()


def changed(text: str, diff: str) -> str:
    """``text`` with the lines with ``-`` of a diff replaced by the lines with ``+`` that follow them."""
    for old, new in re.findall(r"((?:^-.*\n)+)((?:^\+.*\n)*)", diff, re.MULTILINE):
        before, after = (re.sub("^[-+]", "", lines, flags=re.MULTILINE) for lines in (old, new))
        if text.count(before) != 1:
            raise AssertionError(f"the project does not have once what the guide replaces:\n{before}")
        text = text.replace(before, after)
    return text


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def published(port: int, topic: str) -> str:
    """What the broker has retained on a topic (MQTT 3.1.1)."""
    with socket.create_connection(("127.0.0.1", port), timeout=PATIENCE_S) as broker:
        broker.sendall(b"\x10\x10\x00\x04MQTT\x04\x02\x00\x3c\x00\x04test")
        broker.sendall(b"\x82" + bytes([5 + len(topic)]) + b"\x00\x01\x00" + bytes([len(topic)]) + topic.encode() + b"\x00")
        heard = b""
        while topic.rstrip("#").encode() not in heard or not heard.endswith(b"}"):
            more = broker.recv(65_536)
            if not more:
                raise AssertionError(f"the broker hung up after {heard!r}")
            heard += more
        return heard.decode("utf-8", "replace")


def until(what: str, holds: Callable[[], bool]) -> None:
    deadline = time.monotonic() + PATIENCE_S
    while not holds():
        if time.monotonic() > deadline:
            raise AssertionError(f"not within {PATIENCE_S} s: {what}")
        time.sleep(0.1)


class FanCase(unittest.TestCase):
    """A fan, and what operates it, each a process."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory(prefix="evoloop-retrofit-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.port = free_port()
        self.environment = {**os.environ, "XDG_RUNTIME_DIR": str(self.folder / "run")}
        (self.folder / "run").mkdir(mode=0o700)

    def begin(self, command: list[str], **details: object) -> subprocess.Popen[str]:
        log = (self.folder / f"{len(list(self.folder.iterdir()))}.log").open("w+", encoding="utf-8")
        process = subprocess.Popen(  # type: ignore[call-overload]
            command, stdout=log, stderr=subprocess.STDOUT, text=True, env=self.environment, **details
        )
        process.log = Path(log.name)
        log.close()
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process: subprocess.Popen[str]) -> None:
        if process.poll() is None:
            process.kill()
        process.wait(timeout=PATIENCE_S)
        if process.stdin:
            process.stdin.close()

    def begin_fan(self) -> subprocess.Popen[str]:
        _, program, _ = documented("python3 docs/fan/fan.py 4001")
        fan = self.begin([sys.executable, program, str(self.port)], cwd=ROOT, stdin=subprocess.PIPE)
        until("the fan runs", lambda: "the fan is Off" in self.said(fan))
        return fan

    @staticmethod
    def said(process: subprocess.Popen[str]) -> str:
        return str(process.log.read_text(encoding="utf-8"))  # type: ignore[attr-defined]

    def press(self, fan: subprocess.Popen[str], button: str, state: str) -> None:
        assert fan.stdin
        fan.stdin.write(f"{button}\n")
        fan.stdin.flush()
        until(f"{button} leads to {state}", lambda: self.said(fan).strip().endswith(f"the fan is {state}"))

    def begin_broker(self) -> int:
        mqtt = free_port()
        settings = self.folder / "mosquitto.conf"
        settings.write_text(f"listener {mqtt} 127.0.0.1\nallow_anonymous true\n", encoding="utf-8")
        self.begin([BROKER, "-c", str(settings)])
        return mqtt


@unittest.skipUnless(BUILDS_PROJECTS, "slow: ./evoloop test --slow runs it")
class RetrofitTest(FanCase):
    def setUp(self) -> None:
        super().setUp()
        self.project = self.folder / "fan"

    def ctl(self, command: str) -> str:
        """The converter's answer; empty if it is not yet running."""
        line = documented(f"java -cp target/fan.jar org.evoloop.service.Ctl fan {command}")
        return subprocess.run(
            line, cwd=self.project, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, timeout=PATIENCE_S
        ).stdout

    def make_project(self) -> None:
        _, *scaffold = documented(
            "./evoloop models scaffold docs/retrofit.md#original docs/retrofit.md#new --package com.example.fan --out fan"
        )
        models, out = scaffold[1:-1], str(self.project)
        subprocess.run(["java", "-jar", TOOL, *models, out], cwd=ROOT, check=True, capture_output=True, timeout=PATIENCE_S)

    def verify(self, repository: Repository) -> None:
        said = repository.maven(self.project / "pom.xml", "verify")
        self.assertRegex(said, re.compile(r"Tests run: \d+, Failures: 0, Errors: 0, Skipped: 0$", re.MULTILINE))

    def try_the_simulated_fan(self) -> None:
        shown = {
            "start": "running: original Off, new Off",
            "press boost": r"new_current_state: High$",
            "press breeze": r"new_current_state: Breeze$",
            "device overheat": r"overheat(.*\n)*.*new_current_state: Off$",
            "history": r"3 .*overheat.*handled",
            "exit": r"",
        }
        (sentence,) = [line for line in GUIDE.splitlines() if line.startswith("Type `start`")]
        self.assertEqual(re.findall("`(.*?)`", sentence), list(shown))
        program = self.begin(documented("java -jar target/fan.jar"), cwd=self.project, stdin=subprocess.PIPE)
        assert program.stdin
        for typed, expected in shown.items():
            before = len(self.said(program))
            program.stdin.write(f"{typed}\n")
            program.stdin.flush()
            answered = re.compile(expected, re.MULTILINE)
            until(f"{typed} shows {expected}", lambda: bool(answered.search(self.said(program)[before:])))
        self.assertEqual(program.wait(timeout=PATIENCE_S), 0, self.said(program))
        self.assertNotIn("error:", self.said(program))

    def write_code(self) -> None:
        for source in blocks("java"):
            name = re.findall(r"^(?:final )?class (\w+)", source, re.MULTILINE)[0]
            folder = self.project / "src" / ("test" if name.endswith("Test") else "main") / "java" / "com" / "example" / "fan"
            (folder / f"{name}.java").write_text(source, encoding="utf-8")
        pom = self.project / "pom.xml"
        before, end, after = pom.read_text(encoding="utf-8").rpartition("  </dependencies>")
        (dependency,) = [block for block in blocks("xml") if "<dependency>" in block]
        pom.write_text(before + dependency + end + after, encoding="utf-8")
        main = self.project / "src" / "main" / "java" / "com" / "example" / "fan" / "Main.java"
        (diff,) = blocks("diff")
        main.write_text(changed(main.read_text(encoding="utf-8"), diff).replace("4001", str(self.port)), encoding="utf-8")

    def test_the_pictures_show_the_models(self) -> None:
        for name in ("original", "new"):
            with self.subTest(model=name):
                command = ["java", "-jar", TOOL, "show", f"docs/retrofit.md#{name}", "--format", "svg"]
                shown = subprocess.run(command, cwd=ROOT, capture_output=True, check=True, timeout=PATIENCE_S).stdout
                self.assertEqual(shown, (ROOT / "docs" / "fan" / f"{name}.svg").read_bytes())

    def test_the_guide_leads_to_a_fan_in_home_assistant(self) -> None:
        repository = Repository(self.folder / "repository")
        repository.install(*SCAFFOLDED, "line")
        self.make_project()
        self.verify(repository)
        self.try_the_simulated_fan()
        self.write_code()
        self.verify(repository)

        mqtt = self.begin_broker()
        fan = self.begin_fan()
        command = documented("java -jar target/fan.jar --start --name fan --journal journal --mqtt mqtt://localhost")
        self.assertEqual(command[:-2], documented("java -jar target/fan.jar --start --name fan --journal journal"))
        command[-1] += f":{mqtt}"
        converter = self.begin(command, cwd=self.project, stdin=subprocess.DEVNULL)
        until("the converter runs", lambda: "fan, running" in self.ctl("status"))
        until("the fan is connected", lambda: "up, localhost" in self.ctl("status"))

        self.press(fan, "boost", "High")
        self.press(fan, "overheat", "Off")
        until("the converter knows", lambda: "original Off" in self.ctl("status"))
        self.ctl("press boost")
        until("boost leads to High", lambda: self.said(fan).strip().endswith("the fan is High"))
        self.press(fan, "breeze", "Low")
        self.assertIn("Breeze", self.ctl("status"))
        self.assertIn('"boost"', published(mqtt, "homeassistant/device/#"))

        self.end(fan)
        fan = self.begin_fan()
        until("the fan is connected again", lambda: "connected" in self.said(fan))
        self.press(fan, "boost", "High")
        self.ctl("exit")
        self.assertEqual(converter.wait(timeout=PATIENCE_S), 0)


if __name__ == "__main__":
    unittest.main()
