package org.evoloop.device;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.evoloop.device.MqttImitation.Said;
import org.evoloop.device.MqttImitation.Words;

/** What the makers of some devices publish about what these say by MQTT, and understand. */
final class PublishedWords {
    private PublishedWords() {}

    /** A bulb at Zigbee2MQTT. */
    static final class ZigbeeBulb implements Words {
        @Override
        public Said present() {
            return new Said("zigbee2mqtt/bulb/availability", "{\"state\":\"online\"}");
        }

        @Override
        public Optional<String> command(Said message) {
            return message.topic().equals("zigbee2mqtt/bulb/set")
                    ? Optional.of(message.payload().contains("ON") ? "turn on" : "turn off")
                    : Optional.empty();
        }

        @Override
        public boolean asks(Said message) {
            return message.topic().equals("zigbee2mqtt/bulb/get");
        }

        @Override
        public List<Said> reports(String state) {
            return List.of(new Said(
                    "zigbee2mqtt/bulb",
                    "{\"brightness\":254,\"linkquality\":90,\"state\":\"" + (state.equals("On") ? "ON" : "OFF")
                            + "\"}"));
        }
    }

    /** A cover at a Shelly of the second generation. */
    static final class Shutter implements Words {
        private static final Map<String, String> COMMANDS =
                Map.of("open", "open", "close", "close", "stop", "stop", "pos,10", "to gap", "pos,50", "to sun");
        private static final Map<String, String> STATES = Map.of(
                "Open", "\"state\":\"open\",\"current_pos\":100",
                "Closed", "\"state\":\"closed\",\"current_pos\":0",
                "Between", "\"state\":\"stopped\",\"current_pos\":73",
                "Gap", "\"state\":\"stopped\",\"current_pos\":10",
                "Sun", "\"state\":\"stopped\",\"current_pos\":51",
                "Opening", "\"state\":\"opening\",\"current_pos\":20,\"target_pos\":100",
                "Closing", "\"state\":\"closing\",\"current_pos\":20,\"target_pos\":0",
                "ToGap", "\"state\":\"closing\",\"current_pos\":80,\"target_pos\":10",
                "ToSun", "\"state\":\"opening\",\"current_pos\":30,\"target_pos\":50");

        @Override
        public Said present() {
            return new Said("shutter/online", "true");
        }

        @Override
        public Optional<String> command(Said message) {
            return message.topic().equals("shutter/command/cover:0")
                    ? Optional.ofNullable(COMMANDS.get(message.payload()))
                    : Optional.empty();
        }

        @Override
        public boolean asks(Said message) {
            return message.topic().equals("shutter/command")
                    && message.payload().equals("status_update");
        }

        @Override
        public List<Said> reports(String state) {
            return List.of(new Said(
                    "shutter/status/cover:0",
                    "{\"id\":0,\"source\":\"mqtt\"," + STATES.get(state) + ",\"apower\":12.5,\"pos_control\":true}"));
        }
    }

    /** A machine at a plug with Tasmota. */
    static final class Washer implements Words {
        @Override
        public Said present() {
            return new Said("tele/washer/LWT", "Online");
        }

        @Override
        public Optional<String> command(Said message) {
            return message.topic().equals("cmnd/washer/POWER")
                    ? Optional.of(message.payload().equals("ON") ? "switch on" : "switch off")
                    : Optional.empty();
        }

        @Override
        public boolean asks(Said message) {
            return message.topic().equals("cmnd/washer/Status");
        }

        @Override
        public List<Said> reports(String state) {
            double power = state.equals("Running") ? 412.5 : state.equals("Standby") ? 1.2 : 0;
            return List.of(
                    new Said("stat/washer/POWER", state.equals("Off") ? "OFF" : "ON"),
                    new Said("tele/washer/SENSOR", "{\"ENERGY\":{\"Total\":3.1,\"Power\":" + power + "}}"),
                    new Said(
                            "stat/washer/STATUS8",
                            "{\"StatusSNS\":{\"ENERGY\":{\"Total\":3.1,\"Power\":" + power + "}}}"));
        }
    }

    /** A robot with Valetudo. */
    static final class Valetudo implements Words {
        @Override
        public Said present() {
            return new Said("valetudo/robot/$state", "ready");
        }

        @Override
        public Optional<String> command(Said message) {
            return switch (message.topic()) {
                case "valetudo/robot/BasicControlCapability/operation/set" ->
                    Optional.of(message.payload().toLowerCase(Locale.ROOT));
                case "valetudo/robot/ZoneCleaningCapability/start/set" -> Optional.of("spot");
                default -> Optional.empty();
            };
        }

        @Override
        public boolean asks(Said message) {
            return false;
        }

        @Override
        public List<Said> reports(String state) {
            return List.of(new Said("valetudo/robot/StatusStateAttribute/status", state.toLowerCase(Locale.ROOT)));
        }
    }

    /** A plug with Tasmota that only meters what an air conditioner takes. */
    static final class Meter implements Words {
        private static final Map<String, String> WATTS = Map.of("Off", "1.4", "Cool", "540", "Turbo", "1180.5");

        @Override
        public Said present() {
            return new Said("tele/ac/LWT", "Online");
        }

        @Override
        public Optional<String> command(Said message) {
            return Optional.empty();
        }

        @Override
        public boolean asks(Said message) {
            return message.equals(new Said("cmnd/ac/Status", "8"));
        }

        @Override
        public List<Said> reports(String state) {
            String energy = "{\"ENERGY\":{\"Total\":3.1,\"Power\":" + WATTS.get(state) + "}}";
            return List.of(
                    new Said("tele/ac/SENSOR", energy), new Said("stat/ac/STATUS8", "{\"StatusSNS\":" + energy + "}"));
        }
    }

    /** A Roomba with Wi-Fi. */
    static final class WifiRoomba implements Words {
        private static final Map<String, String> PHASES = Map.of(
                "Docked", "charge", "Cleaning", "run", "Stopped", "stop", "Returning", "hmUsrDock", "Stuck", "stuck");

        @Override
        public Said present() {
            return new Said("wifistat", "{}");
        }

        @Override
        public Optional<String> command(Said message) {
            return message.topic().equals("cmd")
                    ? Optional.of(message.payload().replaceFirst(".*\"command\":\"([a-z]+)\".*", "$1"))
                    : Optional.empty();
        }

        @Override
        public boolean asks(Said message) {
            return false;
        }

        @Override
        public List<Said> reports(String state) {
            return List.of(new Said(
                    "$aws/things/BLID/shadow/update",
                    "{\"state\":{\"reported\":{\"batPct\":87,\"cleanMissionStatus\":{\"cycle\":\"clean\",\"phase\":\""
                            + PHASES.get(state) + "\"}}}}"));
        }
    }
}
