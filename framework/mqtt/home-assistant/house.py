"""A broker, the real Home Assistant and Evoloop's programs, as a test's processes."""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

PROJECT = Path(__file__).resolve().parents[3]
ROOT = Path(os.environ.get("EVOLOOP_HOME_ASSISTANT", PROJECT / "target/home-assistant-root"))
BROKER = shutil.which("mosquitto", path=os.environ["PATH"] + ":/usr/sbin") or "mosquitto"
MODELS = ["java", f"-Devoloop.home={PROJECT}", "-jar", str(PROJECT / "framework/models/target/evoloop-models.jar")]
# Device files in the folder "devices", and beside this file.
DEVICES = ("roller-shutter", "air-conditioner", "zigbee-bulb", "fan", "valetudo", "washing-machine")
OWN_FILES = ("garage", "door", "tap", "mist")
PATIENCE_S = 120
# The first start downloads what the integrations need.
INSTALLATION_S = 900

CONFIGURATION = """
logger:
  default: warning
mqtt:
automation:
  - alias: tell
    mode: parallel
    max: 50
    triggers:
      - trigger: mqtt
        topic: test/ask
    actions:
      - action: mqtt.publish
        data:
          topic: "test/told/{{ trigger.payload }}"
          payload: "{{ states(trigger.payload) }}"
  - alias: tell what has failed
    triggers:
      - trigger: state
        entity_id: event.roller_shutter_failure
        not_to: [unknown, unavailable]
    actions:
      - action: mqtt.publish
        data:
          topic: test/failed
          payload: "{{ trigger.to_state.attributes.event_type }}: {{ trigger.to_state.attributes.text }}"
  - alias: call
    mode: parallel
    max: 50
    triggers:
      - trigger: mqtt
        topic: test/call
    actions:
      - action: "{{ trigger.payload_json.action }}"
        target:
          entity_id: "{{ trigger.payload_json.entity }}"
        data: "{{ trigger.payload_json.data }}"
"""


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def program(jar: str, *options: str) -> list[str]:
    return ["java", f"-Devoloop.home={PROJECT}", "-jar", str(PROJECT / jar), "--start", *options]


def store(config: Path, key: str, data: dict[str, Any], version: int, minor_version: int = 1) -> None:
    """Writes what Home Assistant itself would store."""
    stored = {"version": version, "minor_version": minor_version, "key": key, "data": data}
    (config / ".storage" / key).write_text(json.dumps(stored))


def store_port(config: Path, port: int) -> None:
    """The port of Home Assistant's pages; one in the configuration would have to be confirmed there within five minutes."""
    http = {
        "server_host": ["127.0.0.1"], "server_port": port, "cors_allowed_origins": [], "login_attempts_threshold": -1,
        "ip_ban_enabled": True, "ssl_profile": "intermediate_v6", "use_x_frame_options": True,
        "created_at": "2026-11-01T00:00:00+00:00", "error": None, "error_message": None,
    }
    store(config, "http", {"stable": http, "pending": None, "yaml_migration_done": True}, 3)


class House:
    """A house with one broker, which loses everything when it ends."""

    def __init__(self, folder: Path, extra: str = "") -> None:
        """extra: more of Home Assistant's configuration, in YAML."""
        self.folder = folder
        self.extra = extra
        self.port = free_port()
        self.page_port = free_port()
        self.newest: dict[str, str] = {}
        self.processes: dict[str, subprocess.Popen[bytes]] = {}
        (folder / "broker.conf").write_text(f"listener {self.port} 127.0.0.1\nallow_anonymous true\npersistence false\n")
        self.start_broker()
        self._configure()

    def _configure(self) -> None:
        config = self.config = Path(tempfile.mkdtemp(prefix="house-", dir=ROOT))
        (config / ".storage").mkdir()
        (config / "configuration.yaml").write_text(CONFIGURATION + self.extra)
        entry = {
            "created_at": "2026-11-01T00:00:00+00:00", "modified_at": "2026-11-01T00:00:00+00:00",
            "data": {"broker": "127.0.0.1", "port": self.port, "protocol": "5"}, "options": {"discovery": True},
            "disabled_by": None, "discovery_keys": {}, "domain": "mqtt", "entry_id": "01J0000000000000000000MQTT",
            "version": 2, "minor_version": 1, "pref_disable_new_entities": False, "pref_disable_polling": False,
            "source": "user", "subentries": [], "title": "broker", "unique_id": None,
        }
        store(config, "core.config_entries", {"entries": [entry]}, 1, 5)
        store_port(config, self.page_port)

    def start(self, name: str, command: list[str]) -> None:
        with (self.folder / f"{name}.log").open("ab") as log:
            self.processes[name] = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT, start_new_session=True
            )

    def stop(self, name: str, how: signal.Signals = signal.SIGTERM) -> None:
        process = self.processes.pop(name)
        process.send_signal(how)
        process.wait(PATIENCE_S)

    def start_broker(self) -> None:
        self.start("broker", [BROKER, "-c", str(self.folder / "broker.conf")])
        self.wait("the broker", self._listens)
        self.newest.clear()
        listener = subprocess.Popen(
            ["mosquitto_sub", "-p", str(self.port), "-t", "#", "-v"], stdout=subprocess.PIPE, start_new_session=True
        )
        self.processes["listener"] = listener
        threading.Thread(target=self._listen, args=(listener,), daemon=True).start()

    def _listens(self) -> bool:
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0

    def _listen(self, listener: subprocess.Popen[bytes]) -> None:
        assert listener.stdout is not None
        with listener.stdout as lines:
            for line in lines:
                topic, _, payload = line.decode().rstrip("\n").partition(" ")
                self.newest[topic] = payload

    def stop_broker(self) -> None:
        self.stop("listener")
        self.stop("broker", signal.SIGKILL)

    def start_home_assistant_twice(self) -> None:
        """The first start only installs what the integrations need; MQTT triggers work from the second one on."""
        self.start_home_assistant(INSTALLATION_S)
        self.stop("home-assistant")
        (self.folder / "home-assistant.log").unlink()
        self.start_home_assistant()

    def start_programs(self) -> None:
        """Starts the light bulb and a simulated Roomba."""
        url = f"mqtt://127.0.0.1:{self.port}"
        self.start("lamp", program("lightbulb-example/target/lightbulb-example.jar", "--mqtt", url))
        self.start_roomba()

    def start_roomba(self) -> None:
        """A simulated Roomba, at five times its speed, which has quiet hours and a schedule."""
        models = PROJECT / "models/roomba.xml"
        self.start(
            "roomba",
            program(
                "roomba-converter/target/roomba-converter.jar",
                *("--simulate", "--speed", "5", "--original", f"{models}#original", "--new", f"{models}#home"),
                *("--clean-at", "09:00", "--quiet-hours", "22:00-07:00", "--mqtt", f"mqtt://127.0.0.1:{self.port}"),
            ),
        )

    def start_home_assistant(self, limit_s: int = PATIENCE_S) -> None:
        self.newest.pop("homeassistant/status", None)
        # /proc exists for this process only, so nothing stays mounted.
        inside = 'mount -t proc proc "$0/proc" && exec chroot "$0" /venv/bin/hass -c "/$1"'
        self.start("home-assistant", ["unshare", "--mount", "sh", "-c", inside, str(ROOT), self.config.name])
        self.wait("Home Assistant's birth", lambda: self.newest.get("homeassistant/status") == "online", limit_s)

    def start_devices(self) -> None:
        """Starts device files with entities of each kind."""
        for name in OWN_FILES:
            self.start_device(name, Path(__file__).with_name(f"{name}.yaml"))
        for name in DEVICES:
            self.start_device(name, PROJECT / f"devices/{name}/{name}.yaml")

    def start_device(self, name: str, file: Path) -> None:
        """Starts a device file, played by its model."""
        command = [*MODELS, "device", "run", str(file), "--simulate", "--start", "--mqtt", f"mqtt://127.0.0.1:{self.port}"]
        self.start(name, command)

    def call(self, action: str, entity: str, **data: str) -> None:
        self.publish("test/call", json.dumps({"action": action, "entity": entity, "data": data}))

    def publish(self, topic: str, payload: str) -> None:
        subprocess.run(["mosquitto_pub", "-p", str(self.port), "-t", topic, "-m", payload], check=True)

    def shown(self, entity: str) -> str:
        """What Home Assistant shows now, by a new request."""
        self.publish("test/ask", entity)
        return self.newest.pop(f"test/told/{entity}", "")

    def wait_there(self, entity: str) -> None:
        """An entity that does not exist is unknown; a button always is until it is pressed."""
        self.wait(entity, lambda: self.shown(entity) not in ("", "unavailable", "unknown"))

    def wait_shown(self, entity: str, state: str) -> None:
        self.wait(f"{entity} {state}", lambda: self.shown(entity) == state)

    def wait(self, what: str, holds: Callable[[], bool], limit_s: int = PATIENCE_S) -> None:
        deadline = time.monotonic() + limit_s
        while not holds():
            if time.monotonic() > deadline:
                raise AssertionError(f"{what}: not within {limit_s} s; last: {self.newest}")
            time.sleep(0.05)

    def warnings(self) -> list[str]:
        """Home Assistant's warnings about what was published."""
        lines = (self.folder / "home-assistant.log").read_text(errors="replace").splitlines()
        return [line for line in lines if (" WARNING " in line or " ERROR " in line) and self._concerns(line)]

    @staticmethod
    def _concerns(line: str) -> bool:
        # Warnings about the broker, which the test stops, do not count.
        return "evoloop" in line.lower() or ("mqtt" in line and "onnect" not in line and "No ACK" not in line)

    def close(self) -> None:
        for name in list(self.processes):
            self.stop(name)
        shutil.rmtree(self.config)
