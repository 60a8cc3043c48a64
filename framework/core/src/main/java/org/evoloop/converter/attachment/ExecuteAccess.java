package org.evoloop.converter.attachment;

import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** What an execute component does for the converter. Each component has one, which stands for it. */
public abstract class ExecuteAccess {
    /** What execute components are attached to. */
    public interface Host {
        /** Carries out the plan for {@code occurrence} as far as {@code execute} can, on its thread. */
        void carryOut(Occurrence occurrence, Decision plan, ExecuteAccess execute) throws Exception;

        /**
         * The step that {@code execute} was sending has had its effect; only the first call for a step counts.
         *
         * @param inOrder whether it is reported in the order in which everything happened at the device
         */
        void tookEffect(ExecuteAccess execute, boolean inOrder);
    }

    private long sending;

    /** The component's name. */
    public abstract String name();

    /** From now on it carries out what {@code host} gives it, and reports to it. */
    public abstract void attach(Host host, LoopConfig config);

    /** Those that it can send; asked for only once. */
    public abstract Set<Event> events();

    /** Sets the values of the event that is being converted. */
    public abstract void carry(Values values);

    /** Waits until the device can take the event of {@code step}. */
    public abstract void awaitReady(Step step) throws Exception;

    /** Sends the event of {@code step} to the device. */
    public abstract void send(Step step) throws Exception;

    /** {@link #send} has returned: the step counts as having had its effect, if that was not reported before. */
    public abstract void sendReturned();

    /**
     * Asks the device where it is.
     *
     * @param states the state of a name
     * @param isLast whether no other component can be asked, so that a failure is thrown
     * @param reports is told of any other failure
     */
    public abstract Optional<State> locate(Function<String, State> states, boolean isLast, Consumer<Throwable> reports)
            throws Exception;

    /** The system is in the states {@code now}. */
    public abstract void settled(Configuration now) throws Exception;

    /** The device is on its own from now on. */
    public abstract void released() throws Exception;

    /**
     * The number of the step that is being sent and whose effect has not been reported yet; 0 if there is none. Guarded
     * by the host.
     */
    public final long sending() {
        return sending;
    }

    /** Sets the number of the step that is being sent; 0 for none. */
    public final void setSending(long number) {
        sending = number;
    }
}
