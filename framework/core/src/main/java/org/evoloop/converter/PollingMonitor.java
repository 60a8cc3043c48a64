package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.Set;
import org.evoloop.evolution.EventNames;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.ControlLoopFunction.Sensor;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * A monitor that polls once a period, written as a function that returns the name of an event, or null if there is
 * none.
 *
 * <pre>{@code
 * converter.addMonitor(PollingMonitor.ofController("Remote", Duration.ofMillis(50), () -> receiver.poll()));
 * converter.addMonitor(PollingMonitor.ofDevice("Kettle", Duration.ofSeconds(1), Set.of("boils"),
 *         () -> kettle.celsius() >= 99 ? "boils" : null));
 * }</pre>
 *
 * <p>Threading: the function is called on the monitor's thread. In a converter without threads it is called whenever
 * the monitor is observed, whatever the period.
 *
 * @since 0.1
 */
public final class PollingMonitor extends EventMonitor {
    private final Duration period;
    private final Set<String> spontaneous;
    private final Sensor<String> look;
    private final boolean ofDevice;
    private volatile @Nullable Clock clock;
    private boolean looked;

    private PollingMonitor(
            String name, Duration period, boolean ofDevice, Set<String> spontaneous, Sensor<String> look) {
        super(name);
        this.period = Clock.requireDelay(period);
        if (period.isZero()) {
            throw new IllegalArgumentException(
                    "the period of " + name + " is zero; a monitor that waits by itself extends EventMonitor");
        }
        this.ofDevice = ofDevice;
        this.spontaneous = Set.copyOf(spontaneous);
        this.look = requireNonNull(look, "what " + name + " looks at is null");
    }

    /**
     * A monitor that polls a controller.
     *
     * @param name its name in the console, unique within a converter
     * @param period the time between two polls, more than 0
     */
    public static PollingMonitor ofController(String name, Duration period, Sensor<String> look) {
        return new PollingMonitor(name, period, false, Set.of(), look);
    }

    /**
     * A monitor that polls the device for what it does by itself.
     *
     * @param name its name in the console, unique within a converter
     * @param period the time between two polls, more than 0
     * @param events all events that {@code look} may return
     */
    public static PollingMonitor ofDevice(String name, Duration period, Set<String> events, Sensor<String> look) {
        return new PollingMonitor(name, period, true, events, look);
    }

    @Override
    void attached(EventNames names, Clock ofConverter) {
        clock = ofConverter;
    }

    @Override
    protected Set<String> spontaneousEvents() {
        return spontaneous;
    }

    @Override
    protected @Nullable Occurrence getEvent() throws Exception {
        Clock known = clock;
        if (looked && known != null && hasThread()) {
            known.sleep(period);
        }
        looked = true;
        String event = look.read();
        return event == null ? null : ofDevice ? fromDevice(event) : fromController(event);
    }
}
