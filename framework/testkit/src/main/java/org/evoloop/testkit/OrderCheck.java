package org.evoloop.testkit;

import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;

/**
 * Checks that an adapter keeps the order: that a device's own actions and the effects of commands reach the converter
 * in the order in which they happened at the device. An adapter keeps it by reporting both on the thread that reads
 * from the device: a {@link org.evoloop.converter.PushMonitor}'s {@code push}, and {@link
 * org.evoloop.converter.EventExecute}'s {@code tookEffect}.
 *
 * <pre>{@code
 * OrderCheck.of(models.original()).buttons("Clean", "Spot").check(line -> new RobotLink(line).adapter());
 * }</pre>
 *
 * <p>The check simulates the device. Wherever the order matters in the model, the device acts by itself just before, or
 * just after, it takes a command. The check then tests that the converter, which runs with its threads and in real
 * time, knows the device's state afterwards, and was never in doubt.
 *
 * <p>Threading: one thread.
 *
 * @since 0.1
 */
public final class OrderCheck {
    /** Many more would take long without finding more errors. */
    private static final int MOST_SITUATIONS = 60;

    private final StateMachine model;
    private final Set<String> own = new LinkedHashSet<>();
    private final Set<String> unsendable = new LinkedHashSet<>();
    private Duration patience = Duration.ofSeconds(10);

    private OrderCheck(StateMachine model) {
        this.model = model;
        model.spontaneous().forEach(event -> own.add(event.name()));
        unsendable.addAll(own);
        for (Event trigger : model.triggers()) {
            if (trigger.timeTrigger().isPresent()) {
                unsendable.add(trigger.name());
            }
        }
    }

    /** Begins a check with a device of this model; events that it declares to be the device's own are not sent. */
    public static OrderCheck of(StateMachine original) {
        return new OrderCheck(original);
    }

    /**
     * Sets the events that the device takes by itself although they can be sent too, as declared by the adapter's
     * monitor.
     */
    public OrderCheck buttons(String... events) {
        own.addAll(List.of(events));
        return this;
    }

    /** Sets how long the adapter may take, in real time, to report what happened; 10 s by default. */
    public OrderCheck patience(Duration longest) {
        patience = longest;
        return this;
    }

    /**
     * Checks an adapter.
     *
     * @param adapters makes an adapter that already {@linkplain DeviceLine#listen listens} to the line
     * @throws AssertionError if it does not keep the order; the message describes the situation and the reports
     * @throws IllegalStateException if the order matters nowhere in the model, or the adapter does not listen
     * @throws org.evoloop.statemachine.ModelException if the adapter does not fit the model
     */
    public void check(Function<DeviceLine, DeviceAdapter> adapters) {
        Set<String> sendable = new LinkedHashSet<>();
        model.triggers().forEach(trigger -> sendable.add(trigger.name()));
        sendable.removeAll(unsendable);
        List<Situation> situations = Situation.all(model, sendable, own);
        if (situations.isEmpty()) {
            throw new IllegalStateException("in the model " + model.name()
                    + " the order of what the device takes and what it does by itself (" + String.join(", ", own)
                    + ") makes no difference; name all its own events by buttons");
        }
        for (Situation situation : situations.subList(0, Math.min(situations.size(), MOST_SITUATIONS))) {
            try (SituationRun run = new SituationRun(model, own, patience, adapters)) {
                run.play(situation);
            }
        }
    }
}
