"""What the tests of devices share: programs that run, the converter of a device file, and waiting."""

from __future__ import annotations

import os
import re
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
MODELS_JAR = ROOT / "framework" / "models" / "target" / "evoloop-models.jar"
LIMIT_S = 60.0
"""Generous for slow machines: nothing takes nearly as long."""
POLL_S = 0.05
LEARNING_LIMIT_S = 1800.0


def free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


def wait_until(what: str, is_so: Callable[[], bool], now: Callable[[], object] = lambda: "") -> None:
    deadline_s = time.monotonic() + LIMIT_S
    while not is_so():
        if time.monotonic() > deadline_s:
            raise AssertionError(f"after {LIMIT_S} s not so: {what}; {now()}")
        time.sleep(POLL_S)


def accepts(port: int) -> bool:
    try:
        socket.create_connection(("127.0.0.1", port), 1).close()
        return True
    except OSError:
        return False


class Running:
    """A program that is ended by `close`; all that it writes is kept."""

    def __init__(self, command: Sequence[str | Path], folder: Path) -> None:
        self._process = subprocess.Popen(
            [str(word) for word in command],
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, "PATH": os.environ["PATH"] + ":/usr/sbin"},
        )
        self._lines: list[str] = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self._process.stdout
        for line in self._process.stdout:
            self._lines.append(line.rstrip("\n"))

    def type(self, line: str) -> None:
        assert self._process.stdin
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def lines(self) -> list[str]:
        return list(self._lines)

    def close(self) -> None:
        self._process.terminate()
        try:
            self._process.wait(LIMIT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join(LIMIT_S)
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe:
                pipe.close()


JAVA = ["java", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-jar", MODELS_JAR]


def copied(device: str, folder: Path, replaced: dict[str, str]) -> Path:
    """The device file of a device of `devices`, some of whose text is replaced."""
    for name in ("README.md", f"{device}.yaml"):
        text = (ROOT / "devices" / device / name).read_text(encoding="utf-8")
        for old, new in replaced.items():
            text = text.replace(old, new)
        (folder / name).write_text(text, encoding="utf-8")
    return folder / f"{device}.yaml"


def learned(file: Path, model: Path, *options: str) -> str:
    """What learning a device prints; the transitions that were found are in the model."""
    command = [*JAVA, "learn", file, "--output", model, *options]
    done = subprocess.run(
        [str(word) for word in command], cwd=file.parent, capture_output=True, text=True, timeout=LEARNING_LIMIT_S
    )
    if done.returncode != 0:
        raise AssertionError(f"exit status {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout


def arrows(model: Path) -> set[tuple[str, str, str]]:
    """Source, event and target of each transition of a Mermaid file."""
    drawn = re.findall(r"^ +(\w+) --> (\w+) : (.+)$", model.read_text(encoding="utf-8"), re.MULTILINE)
    return {(source, event, target) for source, target, event in drawn}


class Converter(Running):
    """The converter of a device file of `devices`, some of whose text is replaced."""

    def __init__(self, device: str, folder: Path, replaced: dict[str, str]) -> None:
        super().__init__([*JAVA, "device", "run", copied(device, folder, replaced), "--start"], folder)

    def states(self) -> str:
        """The device's state in the record and the new model's, as in `Off, Off`; a doubt is appended."""
        before = len(self.lines())
        self.type("status")
        wait_until("the status", lambda: any(line.startswith("now ") for line in self.lines()[before:]), self.lines)
        status = "\n".join(self.lines()[before:])
        states = re.search("^states +original ([^,]+), new ([^,]+?)(?:, the device in .+)?$", status, re.MULTILINE)
        return ", ".join(states.groups() if states else (status,)) + (" in doubt" if "\nin doubt " in status else "")

    def history(self) -> str:
        """What it has done so far."""
        before = len(self.lines())
        self.type("history")
        self.states()
        return "\n".join(self.lines()[before:])

    def wait_for(self, states: str) -> None:
        wait_until(f"the states are {states}", lambda: self.states() == states, self.history)


class Broker(Running):
    """Mosquitto, for this computer only."""

    def __init__(self, folder: Path) -> None:
        self.port = free_port()
        settings = folder / "mosquitto.conf"
        settings.write_text(f"listener {self.port} 127.0.0.1\nallow_anonymous true\n", encoding="utf-8")
        super().__init__(["mosquitto", "-c", settings], folder)
        wait_until("the broker is there", lambda: accepts(self.port), self.lines)


def temporary() -> tempfile.TemporaryDirectory[str]:
    return tempfile.TemporaryDirectory(prefix="evoloop-devices-")
