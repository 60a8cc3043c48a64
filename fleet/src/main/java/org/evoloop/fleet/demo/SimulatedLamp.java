package org.evoloop.fleet.demo;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Order;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/** A lamp as it is: its original model moves it, and each command is carried out once, whatever the line repeats. */
final class SimulatedLamp {
    private final StateMachine machine;
    private State state;
    private long lastSequence;
    private int repeated;
    private long pressedNanos;
    private String model = "";
    private String shown = "";
    private String system = "";
    private final TreeSet<Long> deadlines = new TreeSet<>();
    private final List<Long> firings = new ArrayList<>();

    SimulatedLamp(StateMachine machine) {
        this.machine = machine;
        this.state = machine.initial();
    }

    /**
     * Carries out a command; null if it has been carried out before.
     *
     * @param broken whether what is sent has no effect
     */
    @Nullable
    Answer obey(Order order, long nowNanos, boolean broken) {
        if (order.sequence() <= lastSequence) {
            repeated++;
            return null;
        }
        lastSequence = order.sequence();
        if (order.deadlineNanos() < nowNanos) {
            return failed(order, "the command arrived after its deadline", nowNanos);
        } else if (order.kind() == Order.Kind.LOCATE) {
            return new Answer(order.sequence(), Answer.Outcome.SENT, "", state, nowNanos);
        } else if (broken) {
            return failed(order, "the lamp does not react", nowNanos);
        }
        if (order.kind() == Order.Kind.SEND) {
            state = machine.transitionsFrom(state).stream()
                    .filter(each -> each.event().trigger().name().equals(order.what()))
                    .findFirst()
                    .map(each -> each.target())
                    .orElse(state);
        }
        return new Answer(order.sequence(), Answer.Outcome.SENT, "", null, nowNanos);
    }

    private static Answer failed(Order order, String reason, long nowNanos) {
        return new Answer(order.sequence(), Answer.Outcome.FAILED, reason, null, nowNanos);
    }

    /** How the fleet has it: its models, and where it and the evolved system are. */
    void shownAs(String version, String deviceState, String systemState) {
        model = version;
        shown = deviceState;
        system = systemState;
    }

    String model() {
        return model;
    }

    /** Whether the fleet has it where it is. */
    boolean isWhereItIsShown() {
        return shown.equals(state.name());
    }

    int repeated() {
        return repeated;
    }

    long sequence() {
        return lastSequence;
    }

    /** Its switch is pressed; only when it is off, a command follows at once. */
    void pressed(long nanos) {
        pressedNanos = system.equals("off") ? nanos : 0;
    }

    /** When it was pressed, the first time that it is asked. */
    long takePress() {
        long nanos = pressedNanos;
        pressedNanos = 0;
        return nanos;
    }

    /** Whether the fleet waits for a timer of it. */
    boolean isWaiting() {
        return system.equals("wait");
    }

    /** A timer of it is due then. */
    void due(long millis) {
        deadlines.add(millis);
    }

    /** A timer of it has fired. */
    void fired(long millis) {
        firings.add(millis);
    }

    /** How many timers have fired for which none was due since the one before. */
    long early() {
        long early = 0;
        long before = Long.MIN_VALUE;
        for (long fired : firings) {
            Long deadline = deadlines.floor(fired);
            early += deadline == null || deadline <= before ? 1 : 0;
            before = fired;
        }
        return early;
    }
}
