package org.evoloop.models.scaffold;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The import lines of a generated class. */
final class Imports {
    private static final List<String> KNOWN = List.of(
            "java.time.Duration",
            "java.time.Instant",
            "java.time.LocalTime",
            "java.nio.file.Path",
            "java.io.IOException",
            "java.util.ArrayList",
            "java.util.Comparator",
            "java.util.List",
            "java.util.Map",
            "java.util.Optional",
            "java.util.function.Consumer",
            "java.util.regex.Pattern",
            "java.util.stream.Collectors",
            "org.evoloop.config.Secret",
            "org.evoloop.converter.DeviceLink",
            "org.evoloop.converter.StateKnowledge",
            "org.evoloop.converter.SystemEventConverter",
            "org.evoloop.evolution.ModelPair",
            "org.evoloop.evolution.Values",
            "org.evoloop.function.NewFunction",
            "org.evoloop.function.Reading",
            "org.evoloop.function.Visit",
            "org.evoloop.http.HttpCall",
            "org.evoloop.gpio.GpioExecute",
            "org.evoloop.gpio.GpioMonitor",
            "org.evoloop.gpio.OutputPin",
            "org.evoloop.gpio.Pins",
            "org.evoloop.homeassistant.EntityValue",
            "org.evoloop.homeassistant.HomeAddress",
            "org.evoloop.homeassistant.HomeConnection",
            "org.evoloop.homeassistant.HomeDevice",
            "org.evoloop.homeassistant.HomeEvents",
            "org.evoloop.homeassistant.HomeExecute",
            "org.evoloop.homeassistant.HomeMonitor",
            "org.evoloop.homeassistant.ServiceCall",
            "org.evoloop.http.HttpExecute",
            "org.evoloop.http.HttpMonitor",
            "org.evoloop.http.HttpPoll",
            "org.evoloop.line.LineConnection",
            "org.evoloop.line.LineExecute",
            "org.evoloop.line.LineMonitor",
            "org.evoloop.line.LineTransport",
            "org.evoloop.line.ProgramCommand",
            "org.evoloop.line.RunExecute",
            "org.evoloop.mqtt.BrokerAddress",
            "org.evoloop.mqtt.BrokerConnection",
            "org.evoloop.mqtt.Message",
            "org.evoloop.mqtt.MqttDevice",
            "org.evoloop.mqtt.MqttExecute",
            "org.evoloop.mqtt.MqttFunctions",
            "org.evoloop.mqtt.MqttMonitor",
            "org.evoloop.payload.Match",
            "org.evoloop.payload.Meanings",
            "org.evoloop.payload.Part",
            "org.evoloop.payload.RemoteFunction",
            "org.evoloop.payload.Template",
            "org.evoloop.program.ProgramSetup",
            "org.evoloop.serial.SerialTransport",
            "org.evoloop.time.Clock");

    private static final Pattern LITERAL = Pattern.compile("\"(?:[^\"\\\\]|\\\\.)*\"");

    private Imports() {}

    /** Those that {@code code} uses, each on a line. */
    static String of(String code) {
        String names = LITERAL.matcher(code).replaceAll("");
        return KNOWN.stream()
                .filter(known -> Pattern.compile(
                                "(?<![\\w.])" + known.substring(known.lastIndexOf('.') + 1) + "(?!\\w)")
                        .matcher(names)
                        .find())
                .sorted()
                .map(known -> "import " + known + ";\n")
                .collect(Collectors.joining());
    }
}
