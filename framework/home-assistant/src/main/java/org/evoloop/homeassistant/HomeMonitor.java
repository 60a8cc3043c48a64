package org.evoloop.homeassistant;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.payload.Inference;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.report.Aftermath;
import org.evoloop.payload.report.Report;
import org.evoloop.payload.report.ReportRules;
import org.jspecify.annotations.Nullable;

/**
 * A monitor of a controller or a device in Home Assistant:
 *
 * <pre>{@code
 * new HomeMonitor("Bulb", device)
 *         .found(EntityValue.state("light.kitchen"), Meanings.of(Map.of("on", "On", "off", "Off")))
 *         .controller(EntityValue.attribute("event.remote_button", "event_type"), Meanings.of(Map.of("press", "press")));
 * }</pre>
 *
 * <p>A value is reported when it changes; one of an entity whose state is a time, such as {@code event} and {@code
 * button}, each time. What an entity is when the connection begins, or when it is available again, is no event, but it is the
 * device's state.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class HomeMonitor extends PushMonitor {
    private final HomeDevice device;
    private final Map<String, EntityValue> values = new LinkedHashMap<>();
    private final Map<String, HomeEvents> sources = new LinkedHashMap<>();
    private final ReportRules events;
    private final ReportRules states;
    private @Nullable Inference inference;

    /** @param name its name in the console, unique within a converter */
    public HomeMonitor(String name, HomeDevice device) {
        super(name);
        this.device = device;
        this.events = new ReportRules(device.clock(), device.connection().turns(), this::subscribe);
        this.states = new ReportRules(
                device.clock(),
                device.connection().turns(),
                (source, consumer) -> device.reports(value(source)).addState(consumer));
    }

    private void subscribe(String source, Consumer<Report> consumer) {
        HomeEvents subscribed = sources.get(source);
        if (subscribed == null) {
            device.reports(value(source)).addEvent(consumer);
        } else {
            device.connection()
                    .listen(subscribed.request(), subscribed.part(), text -> consumer.accept(new Report(text, false)));
        }
    }

    private EntityValue value(String source) {
        EntityValue value = values.get(source);
        if (value == null) {
            throw new IllegalStateException(source + " is no value");
        }
        return value;
    }

    /** Sets the value by which a controller reports operated controls. */
    public final HomeMonitor controller(EntityValue from, Meanings meanings) {
        values.put(from.toString(), from);
        return controller(from.toString(), meanings);
    }

    /** Sets the events by which a controller reports operated controls. */
    public final HomeMonitor controller(HomeEvents from, Meanings meanings) {
        sources.put(from.toString(), from);
        return controller(from.toString(), meanings);
    }

    private HomeMonitor controller(String source, Meanings meanings) {
        controllerRaises(meanings.names());
        events.add(
                source, meanings, ReportRules.Use.EVENT, event -> push(fromController(event.name(), event.values())));
        return this;
    }

    /** Sets the value by which the device reports what it has done by itself. */
    public final HomeMonitor device(EntityValue from, Meanings meanings) {
        values.put(from.toString(), from);
        device.needs(from.entity());
        return device(from.toString(), meanings);
    }

    /** Sets the events by which the device reports what it has done by itself. */
    public final HomeMonitor device(HomeEvents from, Meanings meanings) {
        sources.put(from.toString(), from);
        return device(from.toString(), meanings);
    }

    private HomeMonitor device(String source, Meanings meanings) {
        deviceRaises(meanings.names());
        events.add(source, meanings, ReportRules.Use.EVENT, event -> push(fromDevice(event.name(), event.values())));
        return this;
    }

    /**
     * Sets the value by which the device reports its state. After a command that was {@linkplain HomeExecute#confirmedBy
     * not confirmed} a report may be older than its effect, so a while only the one that confirms it counts.
     *
     * @param meanings states of the original model
     */
    public final HomeMonitor found(EntityValue from, Meanings meanings) {
        String source = from.toString();
        values.put(source, from);
        device.needs(from.entity());
        Aftermath aftermath = device.aftermath(source);
        Consumer<String> found = this::locate;
        states.add(source, meanings, ReportRules.Use.STATE, state -> aftermath.hear(state.name(), found));
        return this;
    }

    private void locate(String state) {
        Inference explains = inference;
        Optional<String> event = explains == null ? Optional.empty() : explains.eventTo(state);
        push(event.map(this::fromDevice).orElseGet(() -> foundIn(state)));
    }

    /**
     * Declares that a changed state is the device's own event if exactly one leads there from the state in which the
     * converter believes the device to be, and no event is being handled. Other changes remain findings.
     *
     * @param converter the converter to which this monitor will be added
     * @param more events that the device takes by itself, beside those that its model declares to be its own
     */
    public final HomeMonitor inferring(SystemEventConverter converter, String... more) {
        deviceRaises(List.of(more));
        inference = new Inference(converter, this::spontaneousEvents);
        return this;
    }
}
