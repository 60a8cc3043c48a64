package org.evoloop.homeassistant;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.evoloop.converter.DeviceLink;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.Part;
import org.evoloop.payload.Readings;
import org.evoloop.payload.report.Aftermath;
import org.evoloop.payload.report.Report;
import org.evoloop.payload.report.ReportingDevice;
import org.evoloop.payload.report.Turns;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Entities of Home Assistant as a device: whether they are there, and readings.
 *
 * <pre>{@code
 * HomeDevice lamp = new HomeDevice(home, clock).reading("power", EntityValue.state("sensor.lamp_power"), "W");
 * converter.addLink(lamp);
 * }</pre>
 *
 * <p>It can be reached while all entities can that tell its state or are operated. One that is {@code unavailable} or
 * {@code unknown} in Home Assistant cannot.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class HomeDevice implements DeviceLink {
    private final HomeConnection connection;
    private final Clock clock;
    private final Map<EntityValue, EntityReports> values = new LinkedHashMap<>();
    private final Map<String, Aftermath> aftermaths = new LinkedHashMap<>();
    private final Map<String, Readings> readings = new TreeMap<>();
    private final Set<String> needed = new LinkedHashSet<>();
    private final List<Consumer<String>> whenLost = new CopyOnWriteArrayList<>();

    /** @param clock measures limits and pauses */
    public HomeDevice(HomeConnection connection, Clock clock) {
        this.connection = connection;
        this.clock = clock;
        connection.onLost(this::lost);
    }

    /**
     * Adds a reading to the status.
     *
     * @param name as of a {@link Reading}, such as {@code battery}
     * @param unit of a number, such as {@code %}; else empty
     */
    public synchronized HomeDevice reading(String name, EntityValue from, String unit) {
        Readings ofEntity = readings.computeIfAbsent(from.entity(), entity -> {
            Readings made = new Readings();
            connection.listen(entity, new Forgetting(made));
            return made;
        });
        String source = from.toString();
        ofEntity.add(source, name, Part.WHOLE, unit);
        reports(from).addState(report -> ofEntity.hear(source, report.text()));
        return this;
    }

    private record Forgetting(Readings readings) implements HomeEntities.Listener {
        @Override
        public void hear(Entity now, boolean old) {}

        @Override
        public void lost(String why) {
            readings.clear();
        }
    }

    /** The reports of a value. */
    synchronized EntityReports reports(EntityValue what) {
        return values.computeIfAbsent(what, first -> {
            EntityReports made = new EntityReports(what, connection.turns());
            connection.listen(what.entity(), made);
            connection.expect(what);
            return made;
        });
    }

    /** Declares that the device cannot be reached without this entity. */
    synchronized void needs(String entity) {
        if (needed.add(entity)) {
            connection.listen(entity, new HomeEntities.Listener() {
                @Override
                public void hear(Entity now, boolean old) {}

                @Override
                public void lost(String why) {
                    HomeDevice.this.lost(why);
                }
            });
        }
    }

    /** Declares that the device is operated by this service. */
    synchronized void needs(ServiceCall call) {
        connection.require(call);
        needed.add(call.toString());
        if (call.entity() != null) {
            needs(call.entity());
        }
    }

    private void lost(String why) {
        whenLost.forEach(action -> action.accept(why));
    }

    /** Asks for the newest states; all that are known then are the answer. */
    void ask(Collection<EntityValue> states) {
        List<String> entities =
                states.stream().map(EntityValue::entity).distinct().toList();
        CompletableFuture<JsonRecord> unused = connection
                .request(ServiceCall.of("homeassistant.update_entity", null)
                        .request(Values.NONE)
                        .put("target", new JsonObject().putTexts("entity_id", entities)))
                .whenComplete((done, failure) -> {
                    if (connection.isUp()) {
                        states.forEach(each -> reports(each).answer());
                    }
                });
    }

    /** It, as what reports its state by values. */
    ReportingDevice reporting(Map<String, EntityValue> bySource) {
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
                return HomeDevice.this.isUp();
            }

            @Override
            public String describe() {
                return HomeDevice.this.describe();
            }

            @Override
            public void subscribeFirst(String source, Consumer<Report> consumer) {
                EntityValue value = bySource.get(source);
                if (value != null) {
                    reports(value).addConfirming(consumer);
                }
            }

            @Override
            public Aftermath aftermath(String source) {
                return HomeDevice.this.aftermath(source);
            }

            @Override
            public void onLost(Consumer<String> action) {
                whenLost.add(action);
            }
        };
    }

    /**
     * What is known of commands to the device that reports its state by this value. What Home Assistant says after a
     * connect is what it knows now, so it counts as any other report.
     */
    synchronized Aftermath aftermath(String source) {
        return aftermaths.computeIfAbsent(source, first -> {
            Aftermath made = new Aftermath(connection.turns());
            whenLost.add(why -> made.isLost());
            return made;
        });
    }

    HomeConnection connection() {
        return connection;
    }

    Clock clock() {
        return clock;
    }

    private synchronized Set<String> needed() {
        return Set.copyOf(needed);
    }

    private @Nullable String wrong() {
        return connection.wrongWith(needed());
    }

    @Override
    public boolean isUp() {
        return connection.isUp() && wrong() == null;
    }

    @Override
    public Optional<Instant> downSince() {
        return connection.downSince().or(() -> connection.entities().wrongSince(needed()));
    }

    @Override
    public synchronized List<Reading> readings() {
        List<Reading> all = new ArrayList<>();
        readings.values().forEach(each -> all.addAll(each.known()));
        return all;
    }

    @Override
    public String describe() {
        String wrong = connection.isUp() ? wrong() : null;
        return wrong == null ? connection.describe() : wrong;
    }
}
