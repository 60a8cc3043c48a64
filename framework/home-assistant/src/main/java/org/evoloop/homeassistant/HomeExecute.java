package org.evoloop.homeassistant;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Rest;
import org.evoloop.payload.report.ConfirmedSending;
import org.evoloop.payload.report.Pending;
import org.evoloop.time.Clock;

/**
 * Sends events to a device by Home Assistant's services:
 *
 * <pre>{@code
 * new HomeExecute("Bulb", device, Map.of("turn on", ServiceCall.of("light.turn_on", "light.kitchen")))
 *         .confirmedBy(EntityValue.state("light.kitchen"), states, Duration.ofSeconds(5));
 * }</pre>
 *
 * <p>Without {@link #confirmedBy} a step has been executed when Home Assistant has carried out the service. While the
 * entity cannot be reached, or does not support the service, a step fails; nothing is sent later or twice.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: as {@link EventExecute}.
 *
 * @since 0.1
 */
public class HomeExecute extends EventExecute {
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private final HomeDevice device;
    private final Map<String, ServiceCall> calls;
    private final Map<String, EntityValue> states = new LinkedHashMap<>();
    private final ConfirmedSending sending;
    private Duration asked = PATIENCE;
    private Rest rest;

    /**
     * A component that sends these events.
     *
     * @param name its name in the console, unique within a converter
     * @param calls the services to call, by event
     */
    public HomeExecute(String name, HomeDevice device, Map<String, ServiceCall> calls) {
        super(name);
        this.device = device;
        this.calls = Map.copyOf(calls);
        this.calls.values().forEach(device::needs);
        this.sending = new ConfirmedSending(device.reporting(states));
        this.rest = new Rest(device.clock(), Duration.ZERO);
    }

    /**
     * Declares that a value reports the device's state: a step has been executed when it reports the state to which the
     * step leads. If it does not within the limit, or the device is lost meanwhile, whether the step had its effect is
     * unknown; it still may have it within the limit again, but no later. Then Home Assistant is asked to read the entity
     * again.
     *
     * @param meanings states of the original model
     * @param limit the time limit from the call to the report
     */
    public final HomeExecute confirmedBy(EntityValue from, Meanings meanings, Duration limit) {
        states.put(from.toString(), from);
        device.needs(from.entity());
        sending.confirmedBy(from.toString(), meanings, limit);
        sending.answeredBy(from.toString(), meanings);
        return this;
    }

    /** Sets the time limit for the answer when the state is asked for; 10 s by default. */
    public final HomeExecute askedWithin(Duration limit) {
        asked = Clock.requireDelay(limit);
        return this;
    }

    /** Sets how long the device needs after each command before it takes the next one. */
    public final HomeExecute readyAfter(Duration pause) {
        rest = new Rest(device.clock(), pause);
        return this;
    }

    @Override
    protected final Set<String> sendableEvents() {
        return calls.keySet();
    }

    @Override
    protected void awaitReady(Step step) throws InterruptedException {
        rest.await();
    }

    @Override
    protected void send(Step step) throws Exception {
        ServiceCall call = calls.get(step.event().name());
        if (call == null) {
            throw new IllegalArgumentException(name() + " has no service for " + step.event());
        }
        // A value that is missing is found before anything waits.
        call.request(values());
        sending.requireUp(step.event().toString());
        try {
            if (sending.isConfirmed(step)) {
                sending.send(step, call.toString(), pending -> send(call, pending), this::tookEffect);
            } else {
                device.connection().carryOut(call, values());
            }
        } finally {
            rest.begin();
        }
    }

    private void send(ServiceCall call, Pending pending) {
        CompletableFuture<JsonRecord> unused = device.connection()
                .call(call, values())
                .whenComplete((done, failure) -> {
                    if (failure == null) {
                        // An entity that was in that state before does not report it again.
                        states.values().forEach(each -> device.reports(each).confirm());
                    } else if (HomeException.isRefusal(failure)) {
                        pending.refuse(call.failed(failure));
                    } else {
                        pending.fail(call.failed(failure));
                    }
                });
    }

    @Override
    protected Optional<String> locate() throws Exception {
        if (!sending.isConfirmed()) {
            return Optional.empty();
        }
        if (!device.isUp()) {
            sending.isUnknown(asked);
        }
        sending.requireUp("the question for its state");
        return Optional.of(sending.ask("the question for its state", pending -> device.ask(states.values()), asked));
    }
}
