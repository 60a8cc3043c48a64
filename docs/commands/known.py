"""All commands in the documentation: how each is run, or why not."""

from __future__ import annotations

from dataclasses import dataclass

FAN = "docs/retrofit.md#original docs/retrofit.md#new"
LAMP = "docs/lightbulb.md#original docs/lightbulb.md#new"
ROBOT = "{robot}"
"""Placeholder for a simulated robot's port, where the documentation has a serial port."""
CAMERA = "{camera}"
"""Placeholder for the address of its camera."""


@dataclass(frozen=True)
class Known:
    """A documented command.

    :param documented: the documented text
    :param run: the command to run, if it differs: with placeholders replaced, or a smaller workload; empty if it is not run
    :param why_not: the reason why it is not run
    :param slow: takes more than half a minute
    :param needs_study: needs the downloads of ./evoloop study; skipped if that was never set up
    :param not_now: a message with which it reports that it cannot run at the moment; then it is skipped
    :param input: its standard input
    :param shows: a part of its standard output
    """

    documented: str
    run: str = ""
    why_not: str = ""
    slow: bool = False
    needs_study: bool = False
    not_now: str = ""
    input: str = ""
    shows: str = ""


def typed(documented: str, **details: object) -> Known:
    """A command that is run as documented."""
    return Known(documented, run=documented, **details)  # type: ignore[arg-type]


THIS = "runs this test"
MUTANTS = "takes several minutes of both processors: over a thousand mutants of the models, a separate test run"
NO_BOARD = "hardware: takes a camera's pictures of a printed chessboard (CalibrationTest draws them)"
CLUSTER = "needs a Kafka cluster; FleetCommandTest of fleet starts a broker and does the same there"
EDGE = "needs a Kafka cluster and an MQTT broker; RoombaEdgeTest starts both, and does the same with a simulated robot"
ELSEWHERE = "is for the project that scaffold writes; test_retrofit.py creates it and runs this there"
FOLLOWED = "test_retrofit_file.py follows the guide, and runs this"

CONSOLE = """start
stop
start
status
status --json
history
history 5
list
press clean
press spot
robot press clean
robot place 500 0 90
robot state
robot help
exchange ExecuteCommand ExecuteCommand2
help
help press
exit
"""

KNOWN = [
    typed("./evoloop help", shows="usage: ./evoloop COMMAND"),
    typed("./evoloop demo", slow=True, shows="remote-start"),
    Known("./evoloop test", why_not=THIS),
    Known("./evoloop test --slow", why_not=THIS),
    Known("./evoloop test --ci", why_not=THIS),
    Known("./evoloop test --oracles", why_not="network: downloads checkers from PyPI; a separate test run"),
    Known("./evoloop test --interop", why_not="network: downloads clients from PyPI; a separate test run"),
    Known("./evoloop test --fresh", why_not="root and network: bare Debians, in which this test runs"),
    Known("./evoloop test --fresh trixie", why_not="root and network: a bare Debian, in which this test runs"),
    Known("./evoloop test --package", why_not="root and network: separate Debians; a separate test run"),
    typed("./evoloop package", slow=True, shows="target/evoloop_"),
    Known("./evoloop test --home-assistant", why_not="root and network: a separate Debian; a separate test run"),
    Known("./evoloop test --stress", why_not="takes several minutes of both processors; a separate test run"),
    typed("./evoloop lightbulb", input="start\nswitch\nstatus\nexit\n", shows="switch"),
    Known(
        "java -cp lightbulb-example/target/lightbulb-example.jar LampConverter.java",
        why_not="takes the program that the README prints; GuideTest of lightbulb-example runs it from there",
    ),
    Known(
        "java -XX:StartFlightRecording=filename=lamp.jfr -jar lightbulb-example.jar",
        run="java -XX:StartFlightRecording=filename=target/lamp.jfr -jar lightbulb-example/target/lightbulb-example.jar",
        input="start\nswitch\nexit\n",
        shows="switch",
    ),
    Known(
        "./evoloop roomba --config roomba.yaml",
        run="./evoloop roomba --config <(printf 'simulate: true\nspeed: 4\n')",
        input="start\nexit\n",
    ),
    Known(
        "./evoloop roomba --config roomba.yaml --print-config",
        run="./evoloop roomba --config <(printf 'simulate: true\nspeed: 4\n') --print-config",
        shows=":2",
    ),
    Known(
        "./evoloop roomba --config roomba.yaml --simulate",
        run="./evoloop roomba --config <(printf 'port: /dev/none\n') --simulate",
        input="start\nexit\n",
    ),
    Known("./evoloop lightbulb --page 8080", run="./evoloop lightbulb --page 0", input="start\nswitch\nexit\n", shows="switch"),
    Known(
        "./evoloop lightbulb --start --mqtt mqtt://homeassistant.local",
        run="./evoloop lightbulb --start --mqtt mqtt://127.0.0.1:1",
        input="switch\nexit\n",
    ),
    Known(
        "EVOLOOP_MQTT_PASSWORD=SECRET ./evoloop roomba --port /dev/ttyUSB0 --start --mqtt mqtt://USER@homeassistant.local",
        run=f"EVOLOOP_MQTT_PASSWORD=SECRET ./evoloop roomba --port {ROBOT} --start --mqtt mqtt://USER@127.0.0.1:1",
        input="status\nexit\n",
    ),
    Known(
        "./evoloop lightbulb --start --switch-pin 17 --lamp-pins 23,24 < /dev/null",
        why_not="hardware: a Raspberry Pi with a button and two LEDs; WiringTest has them on Pi4J's mocked pins",
    ),
    Known(
        "./evoloop lightbulb --start --on-trouble 'logger -t evoloop \"$EVOLOOP_TROUBLE\"'",
        run="./evoloop lightbulb --start --on-trouble true",
        input="switch\nexit\n",
        shows="switch",
    ),
    Known("./evoloop lightbulb --start --name lamp < /dev/null &", why_not="runs until it is ended; ServiceProcessTest runs one"),
    typed("./evoloop ctl", shows=""),
    Known("./evoloop ctl lamp status --json", run="./evoloop ctl --help", shows="status --json"),
    Known("./evoloop ctl lamp switch", run="./evoloop ctl --help", shows="status --json"),
    Known("./evoloop ctl lamp exit", run="./evoloop ctl --help", shows="status --json"),
    Known("java -jar roomba-converter.jar ctl lamp status", run="./evoloop ctl --help", shows="status --json"),
    Known("java -cp fan.jar org.evoloop.service.Ctl fan status", why_not=ELSEWHERE),
    Known("java -cp target/fan.jar org.evoloop.service.Ctl fan press boost", why_not=ELSEWHERE),
    Known("java -cp target/fan.jar org.evoloop.service.Ctl fan status", why_not=ELSEWHERE),
    Known("java -cp target/fan.jar org.evoloop.service.Ctl fan exit", why_not=ELSEWHERE),
    Known("java -jar target/fan.jar --start --name fan --journal journal", why_not=ELSEWHERE),
    Known("java -jar target/fan.jar --start --name fan --journal journal --mqtt mqtt://localhost", why_not=ELSEWHERE),
    Known("./evoloop ctl NAME COMMAND ...", run="./evoloop ctl --help", shows="status --json"),
    Known("./evoloop journal COMMAND DIR", run="./evoloop journal --help", shows="verify"),
    Known(
        "./evoloop journal replay DIR --original models/roomba.xml#original --new models/roomba.xml#guest",
        run="./evoloop journal replay --help",
        shows="--properties",
    ),
    Known(
        "java -jar framework/models/target/evoloop-models.jar journal COMMAND DIR",
        run="java -jar framework/models/target/evoloop-models.jar journal show --help",
        shows="--last",
    ),
    typed("./evoloop install", slow=True),
    typed("./evoloop docs", slow=True, shows="target/site/index.html"),
    typed("./evoloop api", shows="no release yet"),
    Known("./evoloop reproducible", why_not="clones the repository, but the copy in which this test runs is not one"),
    Known("./mvnw -Prelease -Dmaven.test.skip=true deploy", run="./evoloop reproducible --help", shows="SBOM"),
    Known("./mvnw -Prelease -Dmaven.test.skip=true -DskipUpload=false deploy", why_not="uploads to Maven Central"),
    Known("./evoloop fleet --demo", run="./evoloop fleet --demo --devices 200", slow=True, shows="nothing was lost"),
    Known("./evoloop fleet --bootstrap HOST:9092 --create-topics --partitions 64", why_not=CLUSTER),
    Known(
        "./evoloop fleet publish lamp-1 models/light-bulb.xml --timer wait:timeout:2000 --bootstrap HOST:9092",
        why_not=CLUSTER,
    ),
    Known(
        "./evoloop fleet --bootstrap HOST:9092 --create-topics --replicas 3 --topic-config min.insync.replicas=2",
        why_not=CLUSTER,
    ),
    Known("./evoloop fleet resend --list --bootstrap HOST:9092", why_not=CLUSTER),
    Known("./evoloop fleet resend --bootstrap HOST:9092", why_not=CLUSTER),
    Known("./evoloop fleet register --model lamp-1 kitchen hall --bootstrap HOST:9092", why_not=CLUSTER),
    Known("./evoloop fleet --bootstrap HOST:9092", why_not=CLUSTER),
    Known(
        "./evoloop fleet publish lamp-2 models/light-bulb.xml --timer wait:timeout:1000 --bootstrap HOST:9092",
        why_not=CLUSTER,
    ),
    Known(
        "./evoloop fleet rollout quicker --from lamp-1 --to lamp-2 --percent 1 --bootstrap HOST:9092",
        why_not=CLUSTER,
    ),
    Known(
        "./evoloop gateway --bootstrap HOST:9092 --mqtt mqtt://BROKER --device kitchen,hall --journal DIR",
        why_not="needs a Kafka cluster and an MQTT broker; GatewayTest of fleet starts both",
    ),
    Known("./evoloop fleet publish robot-1 models/cleaning-robot.xml --bootstrap HOST:9092", why_not=CLUSTER),
    Known("./evoloop fleet register --model robot-1 robot --bootstrap HOST:9092", why_not=CLUSTER),
    Known("./evoloop gateway --bootstrap HOST:9092 --mqtt mqtt://BROKER --device robot --journal DIR", why_not=EDGE),
    Known(
        "./evoloop roomba edge --port /dev/ttyUSB0 --device robot --mqtt mqtt://BROKER --journal DIR",
        why_not=EDGE,
    ),
    Known("./evoloop bench --fleet", why_not="takes more than ten minutes; --quick does the same with fewer devices"),
    typed("./evoloop bench --fleet --quick", slow=True, shows="events/CPU s"),
    typed("java -version"),
    # Models.
    Known("./evoloop models COMMAND", run="./evoloop models --help", shows="scaffold"),
    Known("./evoloop models", run="./evoloop models --help", shows="scaffold"),
    Known("./evoloop models check", run="./evoloop models check --help", shows="--do-not-pass"),
    Known("./evoloop models scaffold", run="./evoloop models scaffold --help", shows="--package"),
    Known(
        "java -jar framework/models/target/evoloop-models.jar COMMAND",
        run="java -jar framework/models/target/evoloop-models.jar show --help",
        shows="--format",
    ),
    typed(f"./evoloop models diff {LAMP}", shows="incandescent"),
    typed(f"./evoloop models check {LAMP}"),
    Known(
        "./evoloop models show FILE --format svg",
        run="./evoloop models show models/light-bulb.xml --format svg",
        shows="<svg ",
    ),
    typed(f"./evoloop models check {FAN}", shows="swallowed-event"),
    typed(
        "./evoloop models migrate models/roomba.xml#home models/roomba.xml#guest --original models/roomba.xml#original",
        shows="waits until tm(5s) or Clean or Dock leads out",
    ),
    typed(
        "./evoloop models migrate models/cleaning-robot.xml#new models/cleaning-robot-twice.scxml --original models/cleaning-robot.xml#original --spontaneous endSpot --format svg",
        shows="device in On: \u2192 Move",
    ),
    typed(
        "./evoloop models plan models/cleaning-robot.xml#original models/cleaning-robot.xml#new --spontaneous endSpot --bypass",
        shows="something else: the device goes to Spot",
    ),
    Known("./evoloop new my-fan --connection lines --address tcp://127.0.0.1:4001 --events power,speed", why_not=FOLLOWED),
    Known("./evoloop run my-fan/my-fan.yaml --simulate", why_not=FOLLOWED),
    Known("./evoloop check my-fan/my-fan.yaml", why_not=FOLLOWED),
    Known("./evoloop run my-fan/my-fan.yaml --start --name my-fan --journal my-fan/journal", why_not=FOLLOWED),
    Known(
        "./evoloop run my-fan/my-fan.yaml --start --name my-fan --journal my-fan/journal --mqtt mqtt://localhost",
        why_not=FOLLOWED,
    ),
    Known("./evoloop ctl my-fan press boost", why_not=FOLLOWED),
    Known("./evoloop ctl my-fan status", why_not=FOLLOWED),
    Known("./evoloop ctl my-fan exit", why_not=FOLLOWED),
    typed("./evoloop new heater", shows="wrote heater/heater.yaml"),
    Known("./evoloop learn", run="./evoloop learn --help", shows="--output"),
    Known("./evoloop studio", run="./evoloop studio --help", shows="--port"),
    Known("./evoloop studio my-fan", run="./evoloop studio --help", shows="--port"),
    Known("./evoloop studio models --port 8091", run="./evoloop studio --help", shows="--token-file"),
    Known(
        "./evoloop learn --from-journal journal --output fan.mmd",
        run="./evoloop learn --help",
        shows="--from-journal",
    ),
    Known(
        './evoloop learn devices/kettle/kettle.yaml --output kettle.mmd --longest "2 s"',
        run='./evoloop learn devices/kettle/kettle.yaml --output target/kettle-1.mmd --longest "2 s"',
        shows="Boiling --boiled--> Warm",
    ),
    Known(
        "./evoloop models check kettle.mmd#original devices/kettle/README.md#new",
        run='./evoloop learn devices/kettle/kettle.yaml --output target/kettle-2.mmd --longest "2 s" && '
        "./evoloop models check target/kettle-2.mmd#original devices/kettle/README.md#new",
        shows="nothing found",
    ),
    Known(
        "./evoloop run devices/kettle/kettle.yaml --start",
        run='./evoloop learn devices/kettle/kettle.yaml --output target/kettle-3.mmd --longest "2 s" && '
        "(sleep 5; echo 'evolve devices/kettle/README.md#new --original target/kettle-3.mmd#original'; sleep 2; "
        "echo press tea; sleep 3; echo history; sleep 1; echo exit) | ./evoloop run devices/kettle/kettle.yaml --start",
        shows="(Off, Off) -> (Boiling, Boiling)  handled: power, boil",
    ),
    Known("./evoloop learn FILE.yaml --output fan.mmd", run="./evoloop learn --help", shows="--longest"),
    typed("./evoloop check heater/heater.yaml", shows="passed: after ten minutes it is switched off"),
    typed("./evoloop run heater/heater.yaml --simulate", input="start\npress timed\nexit\n"),
    Known("./evoloop run", run="./evoloop run --help", shows="--simulate"),
    typed("./evoloop run --help", shows="--simulate"),
    Known("./evoloop run heater/heater.yaml", why_not="needs the device, which nobody has"),
    typed("./evoloop check devices/light-bulb/light-bulb.yaml", shows="passed: switched twice it gives a warm light"),
    typed("./evoloop run devices/light-bulb/light-bulb.yaml", input="start\npress switch\nexit\n"),
    typed("./evoloop run devices/light-bulb/light-bulb.yaml --simulate", input="start\npress switch\nexit\n"),
    typed("./evoloop check devices/roomba/roomba.yaml", shows="passed: it drives to the spot before it cleans there"),
    typed("./evoloop run devices/roomba/roomba.yaml --simulate", input="start\nrobot press clean\nexit\n"),
    Known("./evoloop run devices/fan/fan.yaml", why_not="needs the fan, whose program it would not end"),
    typed("./evoloop check devices/fan/fan.yaml", shows="passed: boost takes two steps"),
    typed("./evoloop run devices/fan/fan.yaml --simulate --start", input="press boost\nexit\n"),
    typed("./evoloop check devices/zigbee-bulb/zigbee-bulb.yaml", shows="passed: a double press lights both"),
    typed("./evoloop check devices/washing-machine/washing-machine.yaml", shows="passed: the laundry is taken out"),
    typed("./evoloop check devices/air-conditioner/air-conditioner.yaml", shows="passed: boost ends after ten minutes"),
    typed("./evoloop check devices/octoprint/octoprint.yaml", shows="passed: without filament it waits for half an hour"),
    typed("./evoloop check devices/time-clock/time-clock.yaml", shows="passed: a second press takes it back"),
    typed("./evoloop check devices/valetudo/valetudo.yaml", shows="passed: a spot is cleaned, and then it docks"),
    typed("./evoloop check devices/roller-shutter/roller-shutter.yaml", shows="passed: the child lock"),
    typed("./evoloop check devices/wifi-roomba/wifi-roomba.yaml", shows="passed: a stop is resumed"),
    typed(
        "./evoloop check devices/home-assistant-lamp/home-assistant-lamp.yaml",
        shows="passed: a second press within two seconds dims it",
    ),
    typed("./evoloop new my-lamp --from home-assistant-lamp", shows="wrote my-lamp/my-lamp.yaml"),
    typed("./evoloop check my-lamp/my-lamp.yaml", shows="passed: a second press within two seconds dims it"),
    typed("./evoloop run my-lamp/my-lamp.yaml --simulate --start", input="press press\nexit\n"),
    Known("./evoloop run my-lamp/my-lamp.yaml --start", why_not="needs Home Assistant; ./evoloop test --home-assistant"),
    typed("./evoloop new bedroom-light --from zigbee-bulb", shows="wrote bedroom-light/bedroom-light.yaml"),
    Known("./evoloop check devices/NAME/NAME.yaml", run="./evoloop check devices/fan/fan.yaml"),
    typed("./evoloop models check models/README.md#original models/README.md#new"),
    typed("./evoloop models show models/roomba.xml --format mermaid > roomba.md"),
    typed("./evoloop models flatten models/light-bulb.xml#new --format scxml", shows='<state id="incandescentOn">'),
    typed("./evoloop models check docs/fan/fan.uml#original docs/fan/fan.uml#new", shows="swallowed-event"),
    typed(f"./evoloop models plan {FAN}", shows="path power, speed"),
    typed("./evoloop models show docs/retrofit.md#new --format svg > new.svg"),
    typed(f"./evoloop models scaffold {FAN} --package com.example.fan --out fan"),
    typed("./evoloop models scaffold --from devices/fan/fan.yaml --package com.example.fan --out fan-in-java"),
    Known("./mvnw verify", why_not=ELSEWHERE),
    Known("java -jar target/fan.jar", why_not=ELSEWHERE),
    # The robot.
    Known("./evoloop roomba --port /dev/ttyUSB0", run=f"./evoloop roomba --port {ROBOT}", input="start\nstatus\nexit\n"),
    Known(
        "./evoloop roomba --port /dev/ttyUSB0 --original models/roomba.xml#original --new models/roomba.xml#home",
        run=f"./evoloop roomba --port {ROBOT} --original models/roomba.xml#original --new models/roomba.xml#home",
        input="start\npress clean\nstatus --json\nexit\n",
        shows='"battery":',
    ),
    typed("./evoloop roomba --help", shows="--port"),
    typed("./evoloop roomba --simulate --speed 5", input=CONSOLE, shows="xMm"),
    Known(
        "java -jar roomba-converter.jar --port /dev/ttyUSB0",
        run=f"java -jar roomba-converter/target/roomba-converter.jar --port {ROBOT}",
        input="start\nexit\n",
    ),
    Known("./evoloop simulator --link /tmp/robot", run="./evoloop simulator --link robot-2", input="state\n", shows="ready"),
    typed("./evoloop roomba marker --out marker.pdf"),
    Known("./evoloop roomba camera /dev/video0", run=f"./evoloop roomba camera {CAMERA} --seconds 2"),
    Known("./evoloop roomba calibrate --images pictures --board 9x6 --square 25 --out camera.txt", why_not=NO_BOARD),
    Known("./evoloop roomba camera 0 --calibration camera.txt", why_not=NO_BOARD),
    # Measurements.
    Known("./evoloop bench", why_not="takes 15 to 20 minutes; --quick does the same with fewer rounds"),
    typed("./evoloop bench --quick", slow=True, shows="decision"),
    Known("./evoloop bench --only file", run="./evoloop bench --quick --only file", slow=True),
    Known("./evoloop bench --only studio", run="./evoloop bench --quick --only studio", slow=True),
    Known("./evoloop bench --only ring", run="./evoloop bench --quick --only ring", slow=True),
    Known("./evoloop bench --json FILE", run="./evoloop bench --quick --only loading --json rows.json", slow=True),
    Known(
        "./evoloop bench --json benchmarks/results/2026-11-25.json",
        why_not="is ./evoloop bench with a file for its results",
    ),
    Known(
        "./evoloop bench plot benchmarks/results/2026-11-25.json docs/benchmarks.svg",
        run="./evoloop bench plot benchmarks/results/2026-11-25.json docs/benchmarks.svg",
        slow=True,
    ),
    Known("./evoloop bench soak", run="./evoloop bench soak --events 20000", slow=True, shows="20,000 events"),
    Known("./evoloop bench soak --stepped", run="./evoloop bench soak --stepped --events 20000", slow=True),
    Known(
        "./evoloop bench soak --json benchmarks/results/soak/2026-11-25.json --plot docs/soak.svg",
        run="./evoloop bench soak --events 20000 --json soak.json --plot soak.svg",
        slow=True,
    ),
    typed("./evoloop bench profile", slow=True),
    typed("./evoloop bench profile conversion --flame-graphs docs", slow=True),
    typed("./mvnw -q package -pl benchmarks -am -Dmaven.test.skip=true", slow=True),
    typed(
        "java -XX:+UseSerialGC -XX:TieredStopAtLevel=1 -cp benchmarks/target/benchmarks.jar"
        " org.evoloop.benchmarks.running.CameraCost",
        slow=True,
        not_now="other processes were busy",
    ),
    # The study.
    typed("./evoloop study", slow=True, needs_study=True),
    typed("./evoloop study --check", slow=True, needs_study=True),
    Known("./evoloop study --check --slow", why_not=MUTANTS),
    typed("./evoloop study --experiment", slow=True, needs_study=True),
    typed("./evoloop study --measured", slow=True, needs_study=True),
    typed("./evoloop study --proof", slow=True, needs_study=True),
    typed(
        "java -cp prism/experiment/target/study-experiment.jar org.evoloop.study.proof.Main --help",
        slow=True,
    ),
    Known(
        "java -cp prism/experiment/target/study-experiment.jar org.evoloop.study.proof.Main --journal DIR --queue 8"
        " --original FILE#NAME ...",
        run="java -cp prism/experiment/target/study-experiment.jar org.evoloop.study.proof.Main --queue 8"
        " --journal prism/proof/golden/bulb.journal --original models/light-bulb.xml#original"
        " --new models/light-bulb.xml#new --next models/light-bulb.xml#original --mapping prism/proof/light-bulb.mapping.txt"
        " --sendable switch --spontaneous switch --timer wait=timeout",
        slow=True,
        shows="> RECOVERED",
    ),
    Known(
        "prism models/exact.sm models/paper.props -const event_arrive=0.5,conversion=0.25,T=0:5:100",
        why_not="needs PRISM, which is not in Debian; stormpy checks the same files",
    ),
    # For contributors.
    typed("./mvnw spotless:apply", slow=True),
    Known("./mvnw -q spotless:apply -pl framework/check", why_not="the same command for all modules is run"),
    typed("./mvnw -q -pl framework/check -am -Dtest=CheckTest -Dsurefire.failIfNoSpecifiedTests=false test", slow=True),
    Known(
        "./mvnw package -pl roomba-converter -am",
        run="./mvnw -q package -pl roomba-converter -am -Dmaven.test.skip=true",
        slow=True,
    ),
    Known(
        "./mvnw -pl MODULE -am test -Dtest=NAME -Dsurefire.failIfNoSpecifiedTests=false",
        why_not="MODULE and NAME are placeholders for tests that run anyway",
    ),
    typed("./mvnw -pl framework/check -am -Dslow -Dtest=CheckGrowthTest -Dsurefire.failIfNoSpecifiedTests=false test", slow=True),
    typed("./mvnw -pl framework/models -am -Dslow -Dtest=TypingTest -Dsurefire.failIfNoSpecifiedTests=false test", slow=True),
    typed("./mvnw -pl framework/page -am -Dslow -Dtest=LitTimeTest -Dsurefire.failIfNoSpecifiedTests=false test", slow=True),
    Known(
        "./mvnw -pl roomba-converter -am -Dslow -Dsurefire.failIfNoSpecifiedTests=false -Dtest=NAME test",
        why_not="its tests are among those of ./evoloop test --slow, which runs this",
    ),
    typed("./evoloop test --help", shows="--fresh"),
    typed("./evoloop fuzz --help", shows="--minutes N"),
    Known("./evoloop fuzz --minutes 10", why_not="takes ten minutes for each of its targets"),
    typed("./evoloop fuzz commands --minutes 1", slow=True, shows="commands: "),
]
