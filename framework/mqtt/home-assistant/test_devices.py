"""Entities of the real Home Assistant as a converter's device; ./evoloop test --home-assistant runs this."""

from __future__ import annotations

import os
import time
import unittest

from home_case import EVOLOOP, HomeCase, signed

RESTARTS = int(os.environ.get("EVOLOOP_HOME_ASSISTANT_RESTARTS", "20"))
CONNECTIONS = int(os.environ.get("EVOLOOP_CONNECTIONS", "50"))

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


class DevicesTest(HomeCase):
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
