package org.evoloop.converter.running;

import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.evoloop.converter.ChangePlan;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.attachment.ExecuteAccess;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.engine.Output;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.loop.Dispatch;
import org.evoloop.loop.Execute;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * The execute components of a converter, and which of them continues a plan: one that can send the next step, and those
 * that are asked for the device's state or have to settle, one after another.
 *
 * <p>Threading: the components may be read from any thread and are replaced between two events; the rest is for the
 * thread that has the turn.
 */
final class Senders implements Dispatch<ChangePlan> {
    private final CoreDriver driver;
    private volatile List<ExecuteAccess> executes = List.of();

    /** The loop's execute components, in the order in which they are tried. */
    private volatile List<Execute<ChangePlan>> senders = List.of();

    /** The last occurrence of whose plan a component has left a directive for another one; null if there was none. */
    private volatile @Nullable Occurrence shared;

    /** Whether a component has hung. Only the one that has the turn can begin to. */
    private volatile Predicate<Execute<ChangePlan>> stuck = execute -> false;

    Senders(CoreDriver driver) {
        this.driver = driver;
    }

    /** Sets how to find out which components have hung; before the first event. */
    void attach(Predicate<Execute<ChangePlan>> hung) {
        stuck = hung;
    }

    /** Replaces the execute components. */
    void use(List<EventExecute> present) {
        executes = present.stream().map(Friends.EXECUTE::of).toList();
    }

    List<ExecuteAccess> all() {
        return executes;
    }

    /** The events that they can send. */
    Set<Event> sendable() {
        return executes.stream().flatMap(execute -> execute.events().stream()).collect(Collectors.toUnmodifiableSet());
    }

    @Override
    public @Nullable Execute<ChangePlan> next(
            ChangePlan plan, List<Execute<ChangePlan>> inOrder, @Nullable Execute<ChangePlan> last) {
        senders = inOrder;
        if (last == null) {
            return senderOf(firstToSend(plan));
        }
        // Only what was handed back is left to do, and looking takes a lock.
        Agenda agenda = shared == plan.occurrence() ? driver.agendaOf(plan.occurrence()) : null;
        if (agenda == null) {
            return null;
        }
        Output.Directive directive = agenda.peek();
        if (directive instanceof Output.Send send) {
            return senderOf(send.step().trigger());
        }
        if (directive instanceof Output.Settle) {
            return settlesAfter(Friends.EXECUTE.of(last), agenda.settledFirst());
        }
        return directive == null ? null : firstFree(inOrder.indexOf(last) + 1);
    }

    private static @Nullable Event firstToSend(ChangePlan plan) {
        // By index, here and below: an iterator would be garbage in every event.
        for (int index = 0; index < plan.steps().size(); index++) {
            Step step = plan.steps().get(index);
            if (!step.byDevice()) {
                return step.trigger();
            }
        }
        return null;
    }

    private Execute<ChangePlan> senderOf(@Nullable Event event) {
        List<Execute<ChangePlan>> inOrder = senders;
        for (int index = 0; event != null && index < inOrder.size(); index++) {
            if (sends(inOrder.get(index), event)) {
                return inOrder.get(index);
            }
        }
        Execute<ChangePlan> free = firstFree(0);
        return free == null ? inOrder.get(0) : free;
    }

    /** The first component from {@code index} on that has not hung; null if there is none. */
    private @Nullable Execute<ChangePlan> firstFree(int index) {
        List<Execute<ChangePlan>> inOrder = senders;
        for (int next = index; next < inOrder.size(); next++) {
            if (!stuck.test(inOrder.get(next))) {
                return inOrder.get(next);
            }
        }
        return null;
    }

    private static boolean sends(Execute<ChangePlan> execute, Event event) {
        return Friends.EXECUTE.of(execute).events().contains(event);
    }

    // For the component that has the turn

    /** Leaves the directive of the plan for {@code occurrence} that was taken last for another component. */
    void handBack(Occurrence occurrence, Agenda agenda) {
        agenda.handBack();
        shared = occurrence;
    }

    /**
     * Whether {@code execute} can send {@code step}; if not, another one can.
     *
     * @throws IllegalStateException if none can
     */
    boolean canSend(Step step, ExecuteAccess execute) {
        if (execute.events().contains(step.trigger())) {
            return true;
        }
        for (Execute<ChangePlan> other : senders) {
            if (sends(other, step.trigger())) {
                return false;
            }
        }
        throw new IllegalStateException("no execute component can send " + step.trigger() + " any more");
    }

    /** Whether no other component is left to be asked for the device's state. */
    boolean isLast(ExecuteAccess execute) {
        return firstFree(indexOf(execute) + 1) == null;
    }

    private int indexOf(ExecuteAccess execute) {
        List<Execute<ChangePlan>> inOrder = senders;
        int index = inOrder.size() - 1;
        while (index >= 0 && Friends.EXECUTE.of(inOrder.get(index)) != execute) {
            index--;
        }
        return index;
    }

    /**
     * The component that settles after {@code last}; null if all have, but for those that have hung.
     *
     * @param first the one that sent, which has settled first; the others follow in order
     */
    @Nullable
    Execute<ChangePlan> settlesAfter(ExecuteAccess last, @Nullable ExecuteAccess first) {
        List<Execute<ChangePlan>> inOrder = senders;
        int from = last == first ? 0 : indexOf(last) + 1;
        for (int index = from; index < inOrder.size(); index++) {
            Execute<ChangePlan> candidate = inOrder.get(index);
            if (Friends.EXECUTE.of(candidate) != first && !stuck.test(candidate)) {
                return candidate;
            }
        }
        return null;
    }
}
