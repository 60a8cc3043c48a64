package org.evoloop.mqtt;

import java.util.List;
import java.util.regex.Pattern;
import org.evoloop.payload.RemoteFunction;

/**
 * A program that runs a function, by topics: it is told {@code PREFIX/start} and {@code PREFIX/stop}, and says {@code
 * PREFIX/send} and so on, each a JSON object as {@link RemoteFunction} describes. Its last will may be {@code PREFIX/fail}
 * with <code>{}</code>. What the broker has retained is ignored.
 *
 * <p>Threading: as {@link RemoteFunction.Channel}.
 *
 * @since 0.1
 */
public final class MqttFunctions implements RemoteFunction.Channel {
    private static final Pattern NOT_IN_A_LEVEL = Pattern.compile("[+#/\\u0000]");

    private final MqttDevice device;
    private final String prefix;

    /** @param device that is gone if the program is */
    public MqttFunctions(MqttDevice device, String prefix) {
        this.device = device;
        this.prefix = prefix;
    }

    /** The prefix that device files use: {@code evoloop/CONVERTER/function/STATE}. */
    public static String topic(String converter, String state) {
        return "evoloop/" + NOT_IN_A_LEVEL.matcher(converter).replaceAll("_") + "/function/"
                + NOT_IN_A_LEVEL.matcher(state).replaceAll("_");
    }

    @Override
    public boolean isUp() {
        return device.isUp();
    }

    @Override
    public String tell(String verb, String json) {
        if (!isUp()) {
            return device.describe();
        }
        device.connection().publish(Message.command(prefix + "/" + verb, json));
        return "";
    }

    @Override
    public void listen(RemoteFunction.Listener listener) {
        for (String verb : List.of("send", "raise", "finish", "progress", "say", "fail")) {
            device.connection().subscribe(prefix + "/" + verb, message -> {
                if (message.kind() != Message.Kind.STATE) {
                    listener.heard(verb, message.payload());
                }
            });
        }
        device.onLost(listener::lost);
    }

    @Override
    public String toString() {
        return "the program at " + prefix;
    }
}
