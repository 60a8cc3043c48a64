package org.evoloop.mqtt;

import java.time.Instant;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.evoloop.converter.DeviceLink;
import org.evoloop.function.Reading;
import org.evoloop.payload.Match;
import org.evoloop.payload.Part;
import org.evoloop.payload.Readings;
import org.evoloop.payload.report.Aftermath;
import org.evoloop.payload.report.Report;
import org.evoloop.payload.report.ReportingDevice;
import org.evoloop.payload.report.Turns;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * A device behind a broker: whether it is there, and its readings.
 *
 * <pre>{@code
 * MqttDevice lamp = new MqttDevice(broker, clock)
 *         .availability("zigbee2mqtt/lamp/availability", Match.exactly("online").at("/state"))
 *         .reading("power", "zigbee2mqtt/lamp", Part.at("/power"), "W");
 * converter.addLink(lamp);
 * }</pre>
 *
 * <p>Without {@link #availability} the device is there whenever the broker is.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class MqttDevice implements DeviceLink {
    private final BrokerConnection connection;
    private final Clock clock;
    private final Readings readings = new Readings();
    private final Set<String> reported = new LinkedHashSet<>();
    private final List<Consumer<String>> whenLost = new CopyOnWriteArrayList<>();

    /** What the device's availability topic has said last, if that is not that it is there; else null. */
    private volatile @Nullable String away;

    private volatile @Nullable Instant awaySince;

    /** @param clock measures limits and pauses */
    public MqttDevice(BrokerConnection connection, Clock clock) {
        this.connection = connection;
        this.clock = clock;
        connection.onLost(() -> lost(connection.describe()));
    }

    /**
     * Sets the topic that says whether the device is there, such as that of its last will.
     *
     * @param here what is said while it is there; anything else means that it is gone
     */
    public MqttDevice availability(String topic, Match here) {
        connection.subscribe(topic, message -> {
            if (here.of(message.payload()).isPresent()) {
                away = null;
                awaySince = null;
            } else {
                if (awaySince == null) {
                    awaySince = clock.wallTime();
                }
                away = "the device behind " + connection.describe() + " is gone: " + topic + " says '"
                        + message.payload() + "'";
                lost(describe());
            }
        });
        return this;
    }

    /**
     * Adds a reading to the status, from what the device reports.
     *
     * @param name as of a {@link Reading}, such as {@code battery}
     * @param part of the topic's messages that holds the value
     * @param unit of a number, such as {@code %}; else empty
     */
    public synchronized MqttDevice reading(String name, String topic, Part part, String unit) {
        readings.add(topic, name, part, unit);
        if (reported.add(topic)) {
            connection.subscribe(topic, message -> readings.hear(topic, message.payload()));
        }
        return this;
    }

    /** Sets an action for each time that the device or the broker is lost; it receives what is wrong. */
    void onLost(Consumer<String> action) {
        whenLost.add(action);
    }

    private void lost(String why) {
        readings.clear();
        whenLost.forEach(action -> action.accept(why));
    }

    /** It, as what reports its state on topics. */
    ReportingDevice reporting() {
        return new ReportingDevice() {
            @Override
            public Clock clock() {
                return clock;
            }

            @Override
            public Turns turns() {
                return connection.turns();
            }

            @Override
            public boolean isUp() {
                return MqttDevice.this.isUp();
            }

            @Override
            public String describe() {
                return MqttDevice.this.describe();
            }

            @Override
            public void subscribeFirst(String topic, Consumer<Report> consumer) {
                connection.subscribeFirst(topic, message -> consumer.accept(message.report()));
            }

            @Override
            public Aftermath aftermath(String topic) {
                return connection.aftermath(topic);
            }

            @Override
            public void onLost(Consumer<String> action) {
                MqttDevice.this.onLost(action);
            }
        };
    }

    BrokerConnection connection() {
        return connection;
    }

    Clock clock() {
        return clock;
    }

    @Override
    public boolean isUp() {
        return connection.isUp() && away == null;
    }

    @Override
    public Optional<Instant> downSince() {
        return connection.downSince().or(() -> Optional.ofNullable(awaySince));
    }

    @Override
    public List<Reading> readings() {
        return readings.known();
    }

    @Override
    public String describe() {
        String gone = away;
        return gone != null && connection.isUp() ? gone : connection.describe();
    }
}
