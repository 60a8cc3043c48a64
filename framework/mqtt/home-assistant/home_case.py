"""A real Home Assistant with devices to evolve, and converters that use them."""

from __future__ import annotations

import base64
import contextlib
import hashlib
import hmac
import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest
import urllib.error
import urllib.request
from collections.abc import Callable
from pathlib import Path
from typing import Any

from house import INSTALLATION_S, PATIENCE_S, PROJECT, ROOT, free_port, store, store_port
from socket_api import SocketApi

EVOLOOP = f"{PROJECT}/evoloop"

CONFIGURATION = """
logger:
  default: warning
websocket_api:
api:
input_boolean:
  lamp:
  heater:
input_number:
  lamp:
    min: 0
    max: 255
  window:
    min: 0
    max: 100
    initial: 0
demo:
automation:
  - alias: a remote control
    use_blueprint:
      path: evoloop/press-the-converter.yaml
      input:
        triggers:
          - trigger: event
            event_type: remote
        button: input_button.lamp
template:
  - light:
      - name: lamp
        unique_id: lamp
        state: "{{ is_state('input_boolean.lamp', 'on') }}"
        level: "{{ states('input_number.lamp') | int(0) }}"
        turn_on:
          - action: input_boolean.turn_on
            target: {entity_id: input_boolean.lamp}
        turn_off:
          - action: input_boolean.turn_off
            target: {entity_id: input_boolean.lamp}
        set_level:
          - action: input_number.set_value
            target: {entity_id: input_number.lamp}
            data: {value: "{{ brightness }}"}
          - action: input_boolean.turn_on
            target: {entity_id: input_boolean.lamp}
  - cover:
      - name: shed window
        unique_id: window
        position: "{{ states('input_number.window') | int(0) }}"
        open_cover:
          - action: input_number.set_value
            target: {entity_id: input_number.window}
            data: {value: 100}
        close_cover:
          - action: input_number.set_value
            target: {entity_id: input_number.window}
            data: {value: 0}
        set_cover_position:
          - action: input_number.set_value
            target: {entity_id: input_number.window}
            data: {value: "{{ position }}"}
  - sensor:
      - name: room
        unique_id: room
        state: "18"
        unit_of_measurement: "°C"
climate:
  - platform: generic_thermostat
    name: stove
    heater: input_boolean.heater
    target_sensor: sensor.room
    target_temp: 20
    initial_hvac_mode: heat
"""

def signed(refresh_token: str, key: str) -> str:
    """A long-lived access token: a JSON web token, as Home Assistant makes it."""

    def part(content: bytes) -> str:
        return base64.urlsafe_b64encode(content).decode().rstrip("=")

    now = int(time.time())
    claims = {"iss": refresh_token, "iat": now, "exp": now + 86_400}
    text = part(b'{"alg":"HS256","typ":"JWT"}') + "." + part(json.dumps(claims).encode())
    return text + "." + part(hmac.new(key.encode(), text.encode(), hashlib.sha256).digest())


class Wire:
    """Between the converter and Home Assistant: it can be cut."""

    def __init__(self, port: int) -> None:
        self.to = port
        self.ends: list[socket.socket] = []
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = int(self.server.getsockname()[1])
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        while True:
            near = self.server.accept()[0]
            try:
                far = socket.create_connection(("127.0.0.1", self.to))
            except OSError:
                near.close()
                continue
            self.ends += [near, far]
            for source, sink in ((near, far), (far, near)):
                threading.Thread(target=self._pass_on, args=(source, sink), daemon=True).start()

    @staticmethod
    def _pass_on(source: socket.socket, sink: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while data := source.recv(65_536):
                sink.sendall(data)
        for end in (source, sink):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)

    def cut(self) -> None:
        for end in self.ends:
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()
        self.ends.clear()


class HomeCase(unittest.TestCase):
    """A Home Assistant of its own, and converters whose devices are entities of it."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = Path(cls.temporary.name)
        cls.lamp = cls.folder / "my-lamp"
        cls.port = free_port()
        cls.url = f"http://127.0.0.1:{cls.port}"
        cls.wire = Wire(cls.port)
        cls.wired = f"http://127.0.0.1:{cls.wire.port}"
        cls.token = signed("devices", "k" * 128)
        cls.processes: dict[str, subprocess.Popen[bytes]] = {}
        cls.presses = 0
        cls.configure()
        cls.addClassCleanup(shutil.rmtree, cls.config)
        cls.addClassCleanup(cls.end)
        # The first start only installs what the integrations need.
        cls.start_home_assistant(INSTALLATION_S)
        cls.stop("home-assistant")
        (cls.folder / "home-assistant.log").unlink()
        cls.start_home_assistant()

    @classmethod
    def configure(cls) -> None:
        cls.config = Path(tempfile.mkdtemp(prefix="devices-", dir=ROOT))
        (cls.config / ".storage").mkdir()
        (cls.config / "configuration.yaml").write_text(CONFIGURATION)
        blueprints = cls.config / "blueprints/automation/evoloop"
        blueprints.mkdir(parents=True)
        shutil.copy(PROJECT / "docs/home-assistant/press-the-converter.yaml", blueprints)
        user = {
            "id": "owner", "group_ids": ["system-admin"], "is_owner": True, "is_active": True, "name": "owner",
            "system_generated": False, "local_only": False,
        }
        token = {
            "id": "devices", "user_id": "owner", "client_id": None, "client_name": "test", "client_icon": None,
            "token_type": "long_lived_access_token", "created_at": "2026-11-01T00:00:00+00:00",
            "access_token_expiration": 315360000.0, "token": "t" * 128, "jwt_key": "k" * 128, "last_used_at": None,
            "last_used_ip": None, "expire_at": None, "credential_id": None, "version": None,
        }
        groups = [{"id": f"system-{each}", "name": each} for each in ("admin", "users", "read-only")]
        store(cls.config, "auth", {"users": [user], "groups": groups, "credentials": [], "refresh_tokens": [token]}, 1)
        store_port(cls.config, cls.port)
        store(cls.config, "onboarding", {"done": ["user", "core_config", "analytics", "integration"]}, 4)

    @classmethod
    def start_home_assistant(cls, limit_s: int = PATIENCE_S) -> None:
        inside = f'mount -t proc proc "$0/proc" && exec chroot "$0" /venv/bin/hass -c /{cls.config.name}'
        cls.start("home-assistant", ["unshare", "--mount", "sh", "-c", inside, str(ROOT)])
        cls.wait("Home Assistant", lambda: cls.get("config").get("state") == "RUNNING", limit_s)

    @classmethod
    def start(cls, name: str, command: list[str]) -> None:
        with (cls.folder / f"{name}.log").open("ab") as log:
            cls.processes[name] = subprocess.Popen(
                command, cwd=cls.folder, stdin=subprocess.PIPE, stdout=log, stderr=subprocess.STDOUT, start_new_session=True
            )

    @classmethod
    def stop(cls, name: str) -> None:
        process = cls.processes.pop(name)
        assert process.stdin is not None
        process.stdin.close()
        os.killpg(process.pid, signal.SIGTERM)
        process.wait(PATIENCE_S)

    @classmethod
    def end(cls) -> None:
        for name in list(cls.processes):
            cls.stop(name)

    @classmethod
    def request(cls, path: str, body: dict[str, Any] | None = None) -> Any:
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(
            f"{cls.url}/api/{path}", data, {"Authorization": f"Bearer {cls.token}", "Content-Type": "application/json"}
        )
        with urllib.request.urlopen(request, timeout=60) as answer:
            return json.load(answer)

    @classmethod
    def get(cls, path: str) -> dict[str, Any]:
        try:
            return dict(cls.request(path))
        except (OSError, urllib.error.URLError):
            return {}

    def page(self, kind: str, **more: Any) -> Any:
        """Does what an owner does on Home Assistant's pages."""
        with SocketApi(self.port, self.token) as api:
            return api.ask(kind, **more)

    @classmethod
    def wait(cls, what: str, holds: Callable[[], bool], limit_s: int = PATIENCE_S) -> None:
        deadline = time.monotonic() + limit_s
        while not holds():
            if time.monotonic() > deadline:
                logs = {log.name: log.read_text(errors="replace")[-3000:] for log in cls.folder.glob("*.log")}
                raise AssertionError(f"{what}: not within {limit_s} s; {logs}")
            time.sleep(0.05)

    def evoloop(self, *arguments: str) -> str:
        """Runs a command in the test's folder, and requires that it succeeds."""
        done = subprocess.run([EVOLOOP, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def write_file(self, name: str, text: str, models: str, entity: str) -> None:
        """Writes a device file and its models beside the lamp's, which has the token."""
        text = text.replace("URL", self.wired).replace("ENTITY", entity).replace("MODELS", f"{name}.md")
        (self.lamp / f"{name}.yaml").write_text(text)
        (self.lamp / f"{name}.md").write_text(models)

    def run_file(self, name: str) -> None:
        self.start(name, [EVOLOOP, "run", str(self.lamp / f"{name}.yaml"), "--start"])
        self.wait_link(name)

    def wait_link(self, name: str) -> None:
        """Asks until the device can be reached."""
        self.wait_status(name, "link        up, ")

    def wait_state(self, name: str, state: str) -> None:
        """Asks until the record says that the device is in this state."""
        self.wait_status(name, f"original {state}, ")

    def wait_status(self, name: str, text: str) -> None:
        def holds() -> bool:
            before = len(self.log(name))
            self.type(name, "status")
            time.sleep(0.2)
            return text in self.log(name)[before:]

        self.wait(f"{name}: {text}", holds)

    def log(self, name: str) -> str:
        return (self.folder / f"{name}.log").read_text(errors="replace")

    def said(self, name: str, text: str) -> None:
        self.wait(f"{name} says {text}", lambda: text in self.log(name))

    def said_once(self, name: str, text: str) -> None:
        """It is said, and not again with the next attempts to connect."""
        self.said(name, text)
        time.sleep(3)
        self.assertEqual(self.log(name).count(text), 1, self.log(name))

    def type(self, name: str, command: str) -> None:
        stdin = self.processes[name].stdin
        assert stdin is not None
        stdin.write(f"{command}\n".encode())
        stdin.flush()

    def call(self, service: str, entity: str, **data: Any) -> None:
        self.request(f"services/{service}", {"entity_id": entity, **data})

    def press(self) -> None:
        type(self).presses += 1
        self.call("input_button/press", "input_button.lamp")

    def shown(self, entity: str) -> tuple[str, dict[str, Any]]:
        state = self.get(f"states/{entity}")
        return state.get("state", ""), state.get("attributes", {})

    def wait_lamp(self, state: str, brightness: int | None = None) -> None:
        self.wait_light("light.lamp", state, brightness)

    def wait_light(self, entity: str, state: str, brightness: int | None = None) -> None:
        def holds() -> bool:
            now, attributes = self.shown(entity)
            return now == state and (brightness is None or attributes.get("brightness") == brightness)

        self.wait(f"{entity} {state} {brightness}", holds)
