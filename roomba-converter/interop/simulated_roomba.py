"""The simulated Roomba as a process of its own, and its true state."""

from __future__ import annotations

import json
import queue
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

JAR = Path(__file__).resolve().parents[1] / "target" / "roomba-converter.jar"

ANSWER_LIMIT_S = 20.0
"""Generous for slow machines: nothing takes nearly as long."""

POLL_S = 0.01


@dataclass(frozen=True)
class State:
    """The robot's true state, whatever its sensors report."""

    time_millis: int
    activity: str
    oi_mode: str
    x_mm: float
    y_mm: float
    heading_deg: float
    left_mm_per_s: float
    right_mm_per_s: float
    pressed: tuple[str, ...]
    streaming: bool
    battery_percent: int
    bumps: tuple[str, ...]
    baud: int

    @staticmethod
    def parse(line: str) -> State:
        values = json.loads(line)
        return State(
            time_millis=values["timeMillis"],
            activity=values["activity"],
            oi_mode=values["oiMode"],
            x_mm=values["xMm"],
            y_mm=values["yMm"],
            heading_deg=values["headingDeg"],
            left_mm_per_s=values["leftMmPerS"],
            right_mm_per_s=values["rightMmPerS"],
            pressed=tuple(values["pressed"]),
            streaming=values["streaming"],
            battery_percent=values["batteryPercent"],
            bumps=tuple(values["bumps"]),
            baud=values["baud"],
        )

    @property
    def is_at_rest(self) -> bool:
        return self.left_mm_per_s == 0 and self.right_mm_per_s == 0


class SimulatedRoomba:
    """A robot on a pseudo-terminal, which exists until it is closed."""

    def __init__(self, room: str, battery_percent: int) -> None:
        """
        :param room: the lines of a room file
        """
        self._folder = tempfile.TemporaryDirectory(prefix="evoloop-interop-")
        folder = Path(self._folder.name)
        self.port = str(folder / "robot")
        command = ["java", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-jar", str(JAR), "simulator"]
        room_file = folder / "room"
        room_file.write_text(room, encoding="utf-8")
        command += ["--link", self.port, "--room", str(room_file), "--battery", str(battery_percent)]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self._lines: queue.Queue[str] = queue.Queue()
        self._reader = threading.Thread(target=self._read_lines, daemon=True)
        self._reader.start()
        try:
            ready = self._next_line()
            if ready != f"ready {self.port}":
                raise AssertionError(f"the simulator's first line is '{ready}', not its ready line")
        except AssertionError:
            self.close()
            raise

    def _read_lines(self) -> None:
        assert self._process.stdout
        for line in self._process.stdout:
            self._lines.put(line.rstrip("\n"))

    def _next_line(self) -> str:
        try:
            return self._lines.get(timeout=ANSWER_LIMIT_S)
        except queue.Empty:
            raise AssertionError(f"the simulator said nothing for {ANSWER_LIMIT_S} s") from None

    def _ask(self, command: str) -> str:
        assert self._process.stdin
        self._process.stdin.write(command + "\n")
        self._process.stdin.flush()
        answer = self._next_line()
        if answer.startswith("error"):
            raise AssertionError(f"the simulator answered '{command}' by '{answer}'")
        return answer

    def press(self, button: str, millis: int) -> None:
        self._ask(f"press {button} {millis}")

    def place(self, x_mm: float, y_mm: float, heading_deg: float) -> None:
        self._ask(f"place {x_mm} {y_mm} {heading_deg}")

    def state(self) -> State:
        return State.parse(self._ask("state"))

    def wait_until(self, what: str, is_so: Callable[[State], bool]) -> State:
        """Returns the first state for which this is true; raises an AssertionError if there is none in time."""
        deadline_s = time.monotonic() + ANSWER_LIMIT_S
        state = self.state()
        while not is_so(state):
            if time.monotonic() > deadline_s:
                raise AssertionError(f"after {ANSWER_LIMIT_S} s not so: {what}; the robot: {state}")
            time.sleep(POLL_S)
            state = self.state()
        return state

    def wait_millis(self, millis: int) -> State:
        """Lets robot time pass."""
        end_millis = self.state().time_millis + millis
        return self.wait_until(f"{millis} ms have passed", lambda state: state.time_millis >= end_millis)

    def close(self) -> None:
        """Ends the process; just closing its input would not."""
        self._process.terminate()
        try:
            self._process.wait(ANSWER_LIMIT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join(ANSWER_LIMIT_S)
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe:
                pipe.close()
        self._folder.cleanup()
