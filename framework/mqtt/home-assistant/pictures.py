"""Takes the pictures of docs/home-assistant.md in the real Home Assistant: pictures.py [DIRECTORY [all]].

With "all" also those of every device that the test operates, to be looked at.

Needs what ./evoloop test --home-assistant has set up, Chromium, and Python's playwright.
"""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
import urllib.parse
import urllib.request
from pathlib import Path

from house import DEVICES, OWN_FILES, PATIENCE_S, PROJECT, House
from playwright.sync_api import Page as Tab
from playwright.sync_api import sync_playwright

BROWSERS = ("chromium-headless-shell", "chromium")
# Home Assistant saves what it has discovered 10 s later.
REGISTRY_S = 60
WIDTH, HEIGHT = 1280, 1120
# A page with more: its configuration and its pictures shall be seen.
HEIGHTS = {"roomba": 2240}


# Clients on this computer need not log in.
CONFIGURATION = """
homeassistant:
  name: Home
  auth_providers:
    - type: trusted_networks
      trusted_networks: ["127.0.0.1"]
      allow_bypass_login: true
    - type: homeassistant
frontend:
config:
onboarding:
logbook:
"""


class Page:
    """Home Assistant's own page."""

    def __init__(self, port: int) -> None:
        self.url = f"http://127.0.0.1:{port}/"
        self.token = ""

    def post(self, path: str, content: bytes, kind: str) -> dict[str, str]:
        headers = {"Content-Type": kind} | ({"Authorization": f"Bearer {self.token}"} if self.token else {})
        request = urllib.request.Request(self.url + path, content, headers)
        with urllib.request.urlopen(request, timeout=60) as answer:
            return dict(json.load(answer) or {})

    def onboard(self) -> None:
        """Completes Home Assistant's first-run dialogs."""
        client = {"client_id": self.url}
        owner = {"name": "Owner", "username": "owner", "password": "owner of the house", "language": "en"}
        code = self.post("api/onboarding/users", json.dumps(client | owner).encode(), "application/json")["auth_code"]
        login = client | {"grant_type": "authorization_code", "code": code}
        form = urllib.parse.urlencode(login).encode()
        self.token = self.post("auth/token", form, "application/x-www-form-urlencoded")["access_token"]
        for step, answer in (
            ("core_config", {}),
            ("analytics", {}),
            ("integration", client | {"redirect_uri": self.url}),
        ):
            self.post(f"api/onboarding/{step}", json.dumps(answer).encode(), "application/json")

    def take(self, tab: Tab, path: str, last: str, picture: Path) -> None:
        """last: a text that appears last."""
        tab.goto(self.url + path)
        tab.get_by_text(last).first.wait_for()
        tab.screenshot(path=picture, animations="disabled")


def devices(house: House) -> dict[str, str]:
    """The ids of Home Assistant's devices, by their names."""
    registry = house.config / ".storage/core.device_registry"
    if not registry.exists():
        return {}
    return {device["name"].lower(): device["id"] for device in json.loads(registry.read_text())["data"]["devices"]}


def main(target: Path, everything: bool) -> None:
    with tempfile.TemporaryDirectory() as folder:
        house = House(Path(folder), CONFIGURATION)
        try:
            house.start_home_assistant_twice()
            page = Page(house.page_port)
            page.onboard()
            house.start_programs()
            pages = [("lamp", "Press switch"), ("roomba", "Press spot")]
            if everything:
                house.start_devices()
                pages += [(name, "State") for name in (*OWN_FILES, *DEVICES)]
            for entity in ("switch.lamp_converting", "vacuum.roomba"):
                house.wait_there(entity)
            house.call("button.press", "button.lamp_press_switch")
            house.wait_shown("sensor.lamp_state", "on")
            house.call("vacuum.start", "vacuum.roomba")
            house.wait_shown("vacuum.roomba", "cleaning")
            house.wait("Home Assistant's devices", lambda: {name for name, _ in pages} <= devices(house).keys(), REGISTRY_S)
            browser = next((found for found in map(shutil.which, BROWSERS) if found), None)
            if browser is None:
                sys.exit("no Chromium; install chromium-headless-shell")
            with sync_playwright() as playwright:
                tab = playwright.chromium.launch(executable_path=browser).new_page()
                tab.set_default_timeout(PATIENCE_S * 1000)
                for name, last in pages:
                    tab.set_viewport_size({"width": WIDTH, "height": HEIGHTS.get(name, HEIGHT)})
                    page.take(tab, f"config/devices/device/{devices(house)[name]}", last, target / f"home-assistant-{name}.png")
        finally:
            house.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else PROJECT / "docs", sys.argv[2:] == ["all"])
