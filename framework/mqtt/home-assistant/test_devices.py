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

from house import INSTALLATION_S, PATIENCE_S, PROJECT, ROOT, free_port, store, store_port
from socket_api import SocketApi

RESTARTS = int(os.environ.get("EVOLOOP_HOME_ASSISTANT_RESTARTS", "20"))
CONNECTIONS = int(os.environ.get("EVOLOOP_CONNECTIONS", "50"))
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

COVER = """
converter: gap
models: {original: MODELS#original, new: MODELS#new}
connections:
  home: {home-assistant: "URL", token-file: token, entity: ENTITY}
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
models: {original: MODELS#original, new: MODELS#new}
connections:
  home: {home-assistant: "URL", token-file: token, entity: ENTITY}
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

    def test_01_an_owner_without_java_evolves_a_lamp(self) -> None:
        """As "A lamp in 20 minutes" of docs/home-assistant.md says it."""
        # 1. The helper and the token.
        self.assertEqual(self.page("input_button/create", name="lamp")["id"], "lamp")
        token = self.page("auth/long_lived_access_token", client_name="evoloop", lifespan=3650)
        # 2. The copy.
        self.evoloop("new", "my-lamp", "--from", "home-assistant-lamp")
        (self.lamp / "token").touch(mode=0o600)
        (self.lamp / "token").write_text(token + "\n")
        file = self.lamp / "my-lamp.yaml"
        usual = '{home-assistant: "http://homeassistant.local:8123"'
        self.assertIn(usual, file.read_text())
        file.write_text(file.read_text().replace(usual, f'{{home-assistant: "{self.wired}", token-file: token'))
        # 3. Without the lamp.
        self.assertIn("passed: a press lights", self.evoloop("check", "my-lamp/my-lamp.yaml"))
        self.start("simulated", [EVOLOOP, "run", "my-lamp/my-lamp.yaml", "--simulate", "--start"])
        self.wait_status("simulated", "original Off, ")
        self.type("simulated", "press press")
        self.wait_state("simulated", "Bright")
        self.stop("simulated")
        # 4. With it.
        self.run_file("my-lamp")
        self.press()
        self.wait_lamp("on", 255)
        self.press()
        self.wait_lamp("on", 60)
        self.press()
        self.wait_lamp("off")

    def test_02_no_state_is_lost_with_the_connection(self) -> None:
        for _ in range(CONNECTIONS // 2):
            # Whoever operates it meanwhile is found out when the states are read again.
            self.cut()
            self.call("light/turn_on", "light.lamp")
            self.wait_lamp("on")
            self.wait_state("my-lamp", "Bright" if self.shown("light.lamp")[1]["brightness"] >= 128 else "Dim")
            self.cut()
            self.call("light/turn_off", "light.lamp")
            self.wait_state("my-lamp", "Off")
            self.press()
            self.wait_lamp("on", 255)
            self.call("light/turn_off", "light.lamp")
            self.wait_state("my-lamp", "Off")

    def cut(self) -> None:
        # After connections that last for less than 3 s, the next one takes longer and longer.
        time.sleep(3.5)
        self.wire.cut()

    def test_03_no_state_is_lost_with_home_assistant(self) -> None:
        for _ in range(RESTARTS):
            self.stop("home-assistant")
            self.start_home_assistant()
            self.wait_link("my-lamp")
            state = self.shown("light.lamp")[0]
            self.press()
            self.wait_lamp("off" if state == "on" else "on")
            # A press within two seconds would dim it.
            time.sleep(2.5)

    def test_04_each_press_has_counted_once(self) -> None:
        log = self.log("my-lamp")
        self.assertEqual(log.count("button_event : press "), self.presses)
        self.assertEqual(log.count("MAPE-K loop will send this event"), self.presses)

    def test_05_a_blueprint_presses_with_whatever_triggers_an_automation(self) -> None:
        self.call("light/turn_off", "light.lamp")
        self.wait_state("my-lamp", "Off")
        type(self).presses += 1
        self.request("events/remote", {})
        self.wait_lamp("on", 255)
        self.wait_state("my-lamp", "Bright")

    def test_06_another_model_is_taken_over_while_it_runs(self) -> None:
        """Step 5 of "A lamp in 20 minutes": a press in Bright dims the lamp."""
        readme = self.lamp / "README.md"
        self.assertEqual(readme.read_text().count("Bright --> Off : press"), 1)
        readme.write_text(readme.read_text().replace("Bright --> Off : press", "Bright --> Dim : press"))
        self.type("my-lamp", "reload")
        self.said("my-lamp", "evolved to")
        self.call("light/turn_off", "light.lamp")
        self.wait_state("my-lamp", "Off")
        self.press()
        self.wait_lamp("on", 255)
        time.sleep(2.5)
        self.press()
        self.wait_lamp("on", 60)
        self.press()
        self.wait_lamp("off")

    def test_07_a_cover_has_a_gap(self) -> None:
        for entity in ("cover.shed_window", "cover.hall_window"):
            self.write_file("cover", COVER, COVER_MODELS, entity)
            self.call("cover/close_cover", entity)
            self.wait(f"{entity} closed", lambda: self.shown(entity)[0] == "closed")
            self.run_file("cover")
            self.press()
            self.wait(f"the gap of {entity}", lambda: self.shown(entity)[1].get("current_position") == 10)
            self.wait_state("cover", "Gap")
            self.press()
            self.wait(f"{entity} closed again", lambda: self.shown(entity)[0] == "closed")
            self.stop("cover")

    def test_08_a_climate_has_a_boost(self) -> None:
        for entity in ("climate.stove", "climate.hvac"):
            self.write_file("climate", CLIMATE, CLIMATE_MODELS, entity)
            self.call("climate/set_temperature", entity, temperature=20)
            self.run_file("climate")
            self.press()
            self.wait(f"{entity} hot", lambda: self.shown(entity)[1].get("temperature") == 25)
            self.wait(f"{entity} warm again", lambda: self.shown(entity)[1].get("temperature") == 20)
            self.stop("climate")

    def test_09_a_light_has_a_second_press(self) -> None:
        file = (self.lamp / "my-lamp.yaml").read_text()
        self.write_file("demo", file, "", "")
        (self.lamp / "demo.yaml").write_text(file.replace("light.lamp", "light.kitchen_lights"))
        self.call("light/turn_off", "light.kitchen_lights")
        self.run_file("demo")
        self.press()
        self.wait_light("light.kitchen_lights", "on", 255)
        self.press()
        self.wait_light("light.kitchen_lights", "on", 60)
        self.press()
        self.wait_light("light.kitchen_lights", "off")
        self.stop("demo")

    def test_10_an_entity_that_is_renamed_or_disappears_is_said_once(self) -> None:
        registry = "config/entity_registry"
        self.page(f"{registry}/update", entity_id="light.lamp", new_entity_id="light.desk")
        self.said_once("my-lamp", "light.lamp is called light.desk now; write that name")
        self.page(f"{registry}/update", entity_id="light.desk", new_entity_id="light.lamp")
        self.wait_link("my-lamp")
        self.page(f"{registry}/update", entity_id="light.lamp", disabled_by="user")
        self.said_once("my-lamp", "light.lamp is disabled in Home Assistant; enable it in its settings")
        self.page(f"{registry}/update", entity_id="light.lamp", disabled_by=None)
        self.stop("home-assistant")
        self.start_home_assistant()
        self.wait_link("my-lamp")
        self.page(f"{registry}/remove", entity_id="light.lamp")
        self.said_once("my-lamp", "light.lamp is no longer in Home Assistant; if it was removed")
        self.stop("home-assistant")
        self.start_home_assistant()
        self.wait_link("my-lamp")

    def test_11_a_revoked_or_wrong_token_is_said_once_and_another_one_is_taken(self) -> None:
        tokens = self.page("auth/refresh_tokens")
        own = next(each["id"] for each in tokens if each["client_name"] == "evoloop")
        self.page("auth/delete_refresh_token", refresh_token_id=own)
        self.said_once("my-lamp", "refuses the token: it is wrong, or was revoked")
        (self.lamp / "token").write_text(self.token)
        self.wait_link("my-lamp")
        self.stop("my-lamp")
        (self.folder / "my-lamp.log").unlink()
        (self.lamp / "token").write_text(signed("devices", "x" * 128))
        self.start("my-lamp", [EVOLOOP, "run", str(self.lamp / "my-lamp.yaml"), "--start"])
        self.said_once("my-lamp", "refuses the token: it is wrong, or was revoked")
        (self.lamp / "token").write_text(self.token)
        self.wait_link("my-lamp")

    def test_12_home_assistant_has_nothing_against_it(self) -> None:
        lines = self.log("home-assistant").splitlines()
        about = [line for line in lines if " WARNING " in line or " ERROR " in line]
        # What the wrong token of the test before leaves.
        wrong = [
            line
            for line in about
            if ("websocket" in line.lower() or "evoloop" in line.lower()) and "invalid" not in line.lower()
        ]
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
