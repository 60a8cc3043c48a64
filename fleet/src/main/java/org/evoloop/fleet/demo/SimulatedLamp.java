package org.evoloop.fleet.demo;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Order;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/** A simulated lamp: behaves as its original model, and carries out each command once, even if it is delivered twice. */
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

    /** Sets what the fleet shows: its models, and the states of the lamp and the evolved system. */
    void shownAs(String version, String deviceState, String systemState) {
        model = version;
        shown = deviceState;
        system = systemState;
    }

    String model() {
        return model;
    }

    /** Whether the fleet shows its actual state. */
    boolean isWhereItIsShown() {
        return shown.equals(state.name());
    }

    int repeated() {
        return repeated;
    }

    long sequence() {
        return lastSequence;
    }

    /** Its switch is pressed; a command follows at once only if it is off. */
    void pressed(long nanos) {
        pressedNanos = system.equals("off") ? nanos : 0;
    }

    /** Returns the time of the press once, then clears it. */
    long takePress() {
        long nanos = pressedNanos;
        pressedNanos = 0;
        return nanos;
    }

    /** Whether one of its timers runs in the fleet. */
    boolean isWaiting() {
        return system.equals("wait");
    }

    /** One of its timers is due at {@code millis}. */
    void due(long millis) {
        deadlines.add(millis);
    }

    /** One of its timers has fired. */
    void fired(long millis) {
        firings.add(millis);
    }

    /** The number of timers that fired although none was due since the previous one. */
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
