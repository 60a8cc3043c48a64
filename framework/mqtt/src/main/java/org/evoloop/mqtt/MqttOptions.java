package org.evoloop.mqtt;

import java.nio.file.Path;
import java.util.Optional;
import org.evoloop.config.Mistakes;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Secret;
import org.evoloop.config.Settings;

/**
 * The options of a program for the broker through which its converter is shown and operated.
 *
 * @since 0.1
 */
public final class MqttOptions {
    /** The password of the user in {@code --mqtt}. */
    public static final Secret PASSWORD = Secret.named(
            "mqtt-password",
            "The file that holds the password of the user in --mqtt (default: the environment, EVOLOOP_MQTT_PASSWORD).",
            "EVOLOOP_MQTT_PASSWORD");

    private static final Option<BrokerAddress> MQTT = Option.value(
                    "mqtt",
                    "URL",
                    "Shows it in Home Assistant through the MQTT broker mqtt://USER@HOST, or mqtts://USER@HOST with TLS "
                            + "(default: connects to none).",
                    BrokerAddress::parse)
            .placedBy(MqttOptions::placed);

    /** The options of a program. */
    public static final Options OPTIONS = Options.of(MQTT).with(PASSWORD).checking(MqttOptions::check);

    private MqttOptions() {}

    /** The broker; empty if there is none. */
    public static Optional<BrokerAddress> broker(Settings settings) {
        return settings.get(MQTT)
                .map(address -> address.user() == null
                        ? address
                        : PASSWORD.in(settings).map(address::withPassword).orElse(address));
    }

    /**
     * The broker of a program that takes no configuration file: the password, if any, is in the environment.
     *
     * @throws IllegalArgumentException if the URL is malformed
     */
    public static BrokerAddress brokerAt(String url) {
        BrokerAddress address = BrokerAddress.parse(url);
        String password = System.getenv(PASSWORD.variable());
        return password == null ? address : address.withPassword(password);
    }

    private static void check(Settings settings, Mistakes mistakes) {
        if (settings.get(PASSWORD.file()).isPresent()
                && settings.get(MQTT).map(BrokerAddress::user).isEmpty()) {
            mistakes.add(
                    "--mqtt-password-file goes with --mqtt and a user there, as in mqtt://USER@HOST; give both or neither");
        }
    }

    /** A URL with its certificate file relative to the file that contains the URL. */
    private static String placed(String folder, String url) {
        String before = Path.of(folder).toUri().getRawPath().replaceFirst("/?$", "/");
        return url.replaceAll("(?<=[?&]ca=)(?=[^/&])", before.replace("$", "\\$"));
    }
}
