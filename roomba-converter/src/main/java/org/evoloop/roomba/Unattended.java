package org.evoloop.roomba;

import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.page.PageOptions;
import org.evoloop.service.ServiceOptions;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The options of a program that runs by itself. */
final class Unattended {
    @Option(names = "--start", description = "Converts events at once, and goes on when the standard input ends.")
    private boolean start;

    @Option(
            names = "--name",
            paramLabel = "NAME",
            description = "Takes commands for NAME: ctl NAME status (default: nothing listens).")
    private @Nullable String name;

    @Option(
            names = "--page",
            paramLabel = "[HOST:]PORT",
            description =
                    "Shows what the converter does on a page in the browser, to this machine alone unless HOST is "
                            + "given, such as 0.0.0.0 (default: nothing listens).")
    private @Nullable String page;

    /** @throws IllegalArgumentException if it is no address */
    PageOptions page() {
        return page == null ? PageOptions.none() : PageOptions.at(page);
    }

    @Option(
            names = "--mqtt",
            paramLabel = "URL",
            description =
                    "Shows the robot in Home Assistant through this MQTT broker, mqtt://USER@HOST or mqtts://USER@HOST; "
                            + "the password is in the environment, EVOLOOP_MQTT_PASSWORD (default: connects to none).")
    private @Nullable String mqtt;

    /**
     * The broker; null if none is to be connected to.
     *
     * @throws IllegalArgumentException if the URL names none
     */
    @Nullable
    BrokerAddress broker() {
        return mqtt == null ? null : BrokerAddress.parse(mqtt, System.getenv());
    }

    /** @throws IllegalArgumentException if the name is not one */
    ServiceOptions options() {
        ServiceOptions named =
                name == null ? ServiceOptions.none() : ServiceOptions.none().withName(name);
        return start ? named.withStart() : named;
    }
}
