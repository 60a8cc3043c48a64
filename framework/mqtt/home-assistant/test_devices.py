"""Entities of the real Home Assistant as a converter's device; ./evoloop test --home-assistant runs this."""

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

from house import INSTALLATION_S, PATIENCE_S, PROJECT, ROOT, free_port

RESTARTS = int(os.environ.get("EVOLOOP_HOME_ASSISTANT_RESTARTS", "20"))
CONNECTIONS = int(os.environ.get("EVOLOOP_CONNECTIONS", "50"))
# What starts a device file's program; ./evoloop builds it first.
EVOLOOP = os.environ.get("EVOLOOP_RUN", f"{PROJECT}/evoloop run").split()

CONFIGURATION = """
http:
  server_host: 127.0.0.1
  server_port: PORT
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
input_button:
  lamp:
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
      - name: hall window
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
    name: heatpump
    heater: input_boolean.heater
    target_sensor: sensor.room
    target_temp: 20
    initial_hvac_mode: heat
"""

COVER = """
converter: gap
models: {original: cover.md#original, new: cover.md#new}
connections:
  home: {home-assistant: "URL", token-file: token, entity: cover.hall_window}
device:
  send:
    open: cover.open_cover
    close: cover.close_cover
    to gap: {service: cover.set_cover_position, data: {position: 10}}
  state: {attribute: current_position, ranges: {Closed: 0..1, Gap: 10..11, Open: 99..}}
  confirmed: {within: 30 s}
controller:
  press: {entity: input_button.lamp, event: press}
"""

COVER_MODELS = """
## original

```mermaid
stateDiagram-v2
    [*] --> Closed
    Closed --> Open : open
    Closed --> Gap : to gap
    Open --> Closed : close
    Open --> Gap : to gap
    Gap --> Open : open
    Gap --> Closed : close
```

## new

```mermaid
stateDiagram-v2
    [*] --> Closed
    Closed --> Airing : press
    Open --> Airing : press
    Gap --> Airing : press
    Airing : «device Gap»
    Airing --> Closed : press
    Airing --> Open : open
    Closed --> Open : open
    Closed --> Gap : to gap
    Open --> Closed : close
    Open --> Gap : to gap
    Gap --> Open : open
    Gap --> Closed : close
```
"""

CLIMATE = """
converter: boost
models: {original: climate.md#original, new: climate.md#new}
connections:
  home: {home-assistant: "URL", token-file: token, entity: climate.heatpump}
device:
  send:
    warm: {service: climate.set_temperature, data: {temperature: 20}}
    hot: {service: climate.set_temperature, data: {temperature: 25}}
  state: {attribute: temperature, ranges: {Warm: 19.5..22, Hot: 22..}}
controller:
  press: {entity: input_button.lamp, event: press}
"""

CLIMATE_MODELS = """
## original

```mermaid
stateDiagram-v2
    [*] --> Warm
    Warm --> Hot : hot
    Hot --> Warm : warm
```

## new

```mermaid
stateDiagram-v2
    [*] --> Warm
    Warm --> Boost : press
    Boost : «device Hot»
    Boost --> Warm : after 3 s
    Boost --> Warm : warm
    Hot --> Warm : warm
    Hot --> Boost : press
    Warm --> Hot : hot
```
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


class DevicesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = Path(cls.temporary.name)
        cls.port = free_port()
        cls.url = f"http://127.0.0.1:{cls.port}"
        cls.wire = Wire(cls.port)
        cls.wired = f"http://127.0.0.1:{cls.wire.port}"
        cls.token = signed("devices", "k" * 128)
        cls.processes: dict[str, subprocess.Popen[bytes]] = {}
        cls.addClassCleanup(cls.end)
        cls.configure()
        # The first start only installs what the integrations need.
        cls.start_home_assistant(INSTALLATION_S)
        cls.stop("home-assistant")
        (cls.folder / "home-assistant.log").unlink()
        cls.start_home_assistant()
        shutil.copytree(PROJECT / "devices/home-assistant-lamp", cls.folder / "lamp")
        cls.write_token(cls.token)
        file = cls.folder / "lamp/home-assistant-lamp.yaml"
        file.write_text(
            file.read_text().replace(
                '"http://homeassistant.local:8123"', f'"{cls.wired}", token-file: token'
            )
        )
        for name, text, models in (("cover", COVER, COVER_MODELS), ("climate", CLIMATE, CLIMATE_MODELS)):
            (cls.folder / f"lamp/{name}.yaml").write_text(text.replace("URL", cls.wired))
            (cls.folder / f"lamp/{name}.md").write_text(models)

    @classmethod
    def configure(cls) -> None:
        cls.config = ROOT / "devices-config"
        shutil.rmtree(cls.config, ignore_errors=True)
        (cls.config / ".storage").mkdir(parents=True)
        (cls.config / "configuration.yaml").write_text(CONFIGURATION.replace("PORT", str(cls.port)))
        user = {
            "id": "owner", "group_ids": ["system-admin"], "is_owner": True, "is_active": True, "name": "owner",
            "system_generated": False, "local_only": False,
        }
        token = {
            "id": "devices", "user_id": "owner", "client_id": None, "client_name": "evoloop", "client_icon": None,
            "token_type": "long_lived_access_token", "created_at": "2026-11-01T00:00:00+00:00",
            "access_token_expiration": 315360000.0, "token": "t" * 128, "jwt_key": "k" * 128, "last_used_at": None,
            "last_used_ip": None, "expire_at": None, "credential_id": None, "version": None,
        }
        groups = [{"id": f"system-{each}", "name": each} for each in ("admin", "users", "read-only")]
        cls.store("auth", {"users": [user], "groups": groups, "credentials": [], "refresh_tokens": [token]}, 1)
        cls.store("onboarding", {"done": ["user", "core_config", "analytics", "integration"]}, 4)

    @classmethod
    def store(cls, key: str, data: dict[str, Any], version: int) -> None:
        stored = {"version": version, "minor_version": 1, "key": key, "data": data}
        (cls.config / ".storage" / key).write_text(json.dumps(stored))

    @classmethod
    def write_token(cls, token: str) -> None:
        file = cls.folder / "lamp/token"
        file.touch(mode=0o600)
        file.write_text(token)

    @classmethod
    def start_home_assistant(cls, limit_s: int = PATIENCE_S) -> None:
        inside = 'mount -t proc proc "$0/proc" && exec chroot "$0" /venv/bin/hass -c /devices-config'
        cls.start("home-assistant", ["unshare", "--mount", "sh", "-c", inside, str(ROOT)])
        cls.wait("Home Assistant", lambda: cls.get("config").get("state") == "RUNNING", limit_s)

    @classmethod
    def start(cls, name: str, command: list[str]) -> None:
        with (cls.folder / f"{name}.log").open("ab") as log:
            cls.processes[name] = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=log, stderr=subprocess.STDOUT, start_new_session=True
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

    @classmethod
    def wait(cls, what: str, holds: Callable[[], bool], limit_s: int = PATIENCE_S) -> None:
        deadline = time.monotonic() + limit_s
        while not holds():
            if time.monotonic() > deadline:
                logs = {log.name: log.read_text(errors="replace")[-3000:] for log in cls.folder.glob("*.log")}
                raise AssertionError(f"{what}: not within {limit_s} s; {logs}")
            time.sleep(0.05)

    def run_file(self, name: str, file: str) -> None:
        self.start(name, [*EVOLOOP, str(self.folder / "lamp" / file), "--start"])
        self.wait_link(name)

    def wait_link(self, name: str) -> None:
        """Asks until the device can be reached."""

        def holds() -> bool:
            before = len(self.log(name))
            self.type(name, "status")
            time.sleep(0.2)
            return "link        up, " in self.log(name)[before:]

        self.wait(f"the link of {name}", holds)

    def wait_state(self, name: str, state: str) -> None:
        """Asks until the record says that the device is in this state."""

        def holds() -> bool:
            before = len(self.log(name))
            self.type(name, "status")
            time.sleep(0.2)
            return f"original {state}, " in self.log(name)[before:]

        self.wait(f"{name} {state}", holds)

    def log(self, name: str) -> str:
        return (self.folder / f"{name}.log").read_text(errors="replace")

    def said(self, name: str, text: str) -> None:
        self.wait(f"{name} says {text}", lambda: text in self.log(name))

    def type(self, name: str, command: str) -> None:
        stdin = self.processes[name].stdin
        assert stdin is not None
        stdin.write(f"{command}\n".encode())
        stdin.flush()

    def call(self, service: str, entity: str) -> None:
        self.request(f"services/{service}", {"entity_id": entity})

    def press(self) -> None:
        self.call("input_button/press", "input_button.lamp")

    def shown(self, entity: str) -> tuple[str, dict[str, Any]]:
        state = self.get(f"states/{entity}")
        return state.get("state", ""), state.get("attributes", {})

    def wait_lamp(self, state: str, brightness: int | None = None) -> None:
        def holds() -> bool:
            now, attributes = self.shown("light.lamp")
            return now == state and (brightness is None or attributes.get("brightness") == brightness)

        self.wait(f"light.lamp {state} {brightness}", holds)

    def test_1_the_lamp_has_a_second_press(self) -> None:
        self.run_file("lamp", "home-assistant-lamp.yaml")
        self.press()
        self.wait_lamp("on", 255)
        self.press()
        self.wait_lamp("on", 60)
        self.press()
        self.wait_lamp("off")

    def test_2_no_state_is_lost_with_the_connection(self) -> None:
        for _ in range(CONNECTIONS // 2):
            # Whoever operates it meanwhile is found out when the states are read again.
            self.cut()
            self.call("light/turn_on", "light.lamp")
            self.wait_lamp("on")
            self.wait_state("lamp", "Bright" if self.shown("light.lamp")[1]["brightness"] >= 128 else "Dim")
            self.cut()
            self.call("light/turn_off", "light.lamp")
            self.wait_state("lamp", "Off")
            self.press()
            self.wait_lamp("on", 255)
            self.call("light/turn_off", "light.lamp")
            self.wait_state("lamp", "Off")

    def cut(self) -> None:
        # After connections that last for less than 3 s, the next one takes longer and longer.
        time.sleep(3.5)
        self.wire.cut()

    def test_3_no_state_is_lost_with_home_assistant(self) -> None:
        for _ in range(RESTARTS):
            self.stop("home-assistant")
            self.start_home_assistant()
            self.wait_link("lamp")
            state = self.shown("light.lamp")[0]
            self.press()
            self.wait_lamp("off" if state == "on" else "on")
            # A press within two seconds would dim it.
            time.sleep(2.5)

    def test_4_the_cover_has_a_gap(self) -> None:
        self.run_file("cover", "cover.yaml")
        self.press()
        self.wait("the gap", lambda: self.shown("cover.hall_window")[1].get("current_position") == 10)
        self.said("cover", "original_current_state: Gap")
        self.press()
        self.wait("closed", lambda: self.shown("cover.hall_window")[0] == "closed")
        self.stop("cover")

    def test_5_the_climate_has_a_boost(self) -> None:
        self.run_file("climate", "climate.yaml")
        self.press()
        self.wait("hot", lambda: self.shown("climate.heatpump")[1].get("temperature") == 25)
        self.wait("warm again", lambda: self.shown("climate.heatpump")[1].get("temperature") == 20)
        self.stop("climate")

    def test_6_a_wrong_token_is_said_once_and_another_one_is_taken(self) -> None:
        self.stop("lamp")
        (self.folder / "lamp.log").unlink()
        self.write_token(signed("devices", "x" * 128))
        self.start("lamp", [*EVOLOOP, str(self.folder / "lamp/home-assistant-lamp.yaml"), "--start"])
        self.said("lamp", "refuses the token")
        time.sleep(3)
        self.assertEqual(self.log("lamp").count("refuses the token"), 1)
        self.write_token(self.token)
        self.wait_link("lamp")

    def test_7_home_assistant_has_nothing_against_it(self) -> None:
        lines = self.log("home-assistant").splitlines()
        about = [line for line in lines if " WARNING " in line or " ERROR " in line]
        # What the wrong token of the test before leaves.
        wrong = [line for line in about if "websocket" in line.lower() and "invalid" not in line.lower()]
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
