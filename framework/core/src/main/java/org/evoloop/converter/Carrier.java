package org.evoloop.converter;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.core.Output;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.flight.WorkEvent;
import org.evoloop.loop.Execute;
import org.evoloop.loop.Failure;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Carries out the core's directives: on the threads of the execute components, one at a time; those that belong to no
 * occurrence on the thread that opens, closes or gives up.
 */
final class Carrier {
    private final CoreDriver driver;
    private final Visits visits;
    private final CurrentKnowledge knowledge;
    private final Books books;
    private final Reports reports;
    private volatile List<EventExecute> executes = List.of();

    /** The loop's execute components, in the order in which they are tried. */
    private volatile List<Execute<ChangePlan>> senders = List.of();

    /** Whether the execute component that returned last left a directive for another one. */
    private volatile boolean handedBack;

    /** The execute component that settled first; null if none has and others still have to. */
    private volatile @Nullable EventExecute settledFirst;

    private volatile String runningEffect = "";

    /** Is told of failures of components that do not end the event, since others continue. */
    interface Reports {
        void failed(EventExecute execute, String phase, Exception cause);
    }

    Carrier(CoreDriver driver, Visits visits, CurrentKnowledge knowledge, Books books, Reports reports) {
        this.reports = reports;
        this.driver = driver;
        this.visits = visits;
        this.knowledge = knowledge;
        this.books = books;
    }

    /** Replaces the execute components. */
    void use(List<EventExecute> present) {
        executes = List.copyOf(present);
    }

    List<EventExecute> executes() {
        return executes;
    }

    /** The events that they can send. */
    Set<Event> sendable() {
        return executes().stream()
                .flatMap(execute -> execute.events().stream())
                .collect(Collectors.toUnmodifiableSet());
    }

    /** The execute component that continues {@code plan}; null if it has been carried out. */
    @Nullable
    Execute<ChangePlan> next(ChangePlan plan, List<Execute<ChangePlan>> inOrder, @Nullable Execute<ChangePlan> last) {
        senders = inOrder;
        if (last == null) {
            settledFirst = null;
            return senderOf(firstToSend(plan), inOrder);
        }
        // Only what was handed back is left to do, and looking takes a lock.
        Output.Directive directive = handedBack ? driver.toDo(plan) : null;
        if (directive instanceof Output.Send send) {
            return senderOf(send.step().trigger(), inOrder);
        }
        if (directive instanceof Output.Settle && last instanceof EventExecute settled) {
            return settlesAfter(settled);
        }
        return directive == null ? null : inOrder.get(inOrder.indexOf(last) + 1);
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

    private static Execute<ChangePlan> senderOf(@Nullable Event event, List<Execute<ChangePlan>> inOrder) {
        for (int index = 0; event != null && index < inOrder.size(); index++) {
            if (sends(inOrder.get(index), event)) {
                return inOrder.get(index);
            }
        }
        return inOrder.get(0);
    }

    private static boolean sends(Execute<ChangePlan> execute, Event event) {
        return execute instanceof EventExecute sender && sender.events().contains(event);
    }

    /** Carries out {@code plan} as far as {@code execute} can. */
    void carryOut(ChangePlan plan, EventExecute execute) throws Exception {
        Agenda agenda = driver.takeUp(plan);
        handedBack = false;
        long number = agenda.turn();
        Exception notSettled = null;
        for (Output.Directive next = agenda.poll(); next != null; next = agenda.poll()) {
            if (next instanceof Output.Send send) {
                if (!canSend(send.step(), execute)) {
                    handBack(agenda, next);
                    return;
                }
                send(number, send.step(), plan.occurrence().values(), execute);
            } else if (next instanceof Output.Run run) {
                driver.announceEffect(number);
                driver.ran(number, run(run.effect(), plan.occurrence(), execute));
            } else if (next instanceof Output.Locate) {
                boolean last = senders.indexOf(execute) == senders.size() - 1;
                State state = execute.locate(knowledge.get(), last, cause -> reports.failed(execute, "locate", cause))
                        .orElse(null);
                if (state == null && !last) {
                    handBack(agenda, next);
                    return;
                }
                driver.located(number, state);
            } else if (next instanceof Output.Settle settle) {
                books.transcript().say();
                notSettled = settle(execute, settle);
                if (settlesAfter(execute) != null) {
                    if (notSettled != null) {
                        reports.failed(execute, "settled", notSettled);
                    }
                    handBack(agenda, next);
                    return;
                }
            } else {
                visit(next, plan.decision().leavesState() ? plan.occurrence().values() : null);
            }
        }
        books.transcript().say();
        if (notSettled != null) {
            throw notSettled;
        }
    }

    /** Returns what {@code execute} threw; null if it has settled. */
    private @Nullable Exception settle(EventExecute execute, Output.Settle settle) {
        settledFirst = settledFirst == null ? execute : settledFirst;
        try {
            execute.settled(settle.now());
            return null;
        } catch (Exception cause) {
            return cause;
        }
    }

    /** The component that settles after {@code last}: the one that sent comes first, the others follow in order. */
    private @Nullable EventExecute settlesAfter(EventExecute last) {
        EventExecute first = settledFirst;
        int from = last == first ? 0 : senders.indexOf(last) + 1;
        for (int index = from; index < senders.size(); index++) {
            if (senders.get(index) != first && senders.get(index) instanceof EventExecute next) {
                return next;
            }
        }
        return null;
    }

    private void handBack(Agenda agenda, Output.Directive directive) {
        agenda.handBack(directive);
        handedBack = true;
    }

    private boolean canSend(Step step, EventExecute execute) {
        if (sends(execute, step.trigger())) {
            return true;
        }
        for (Execute<ChangePlan> other : senders) {
            if (sends(other, step.trigger())) {
                return false;
            }
        }
        throw new IllegalStateException("no execute component can send " + step.trigger() + " any more");
    }

    private void send(long number, Step step, Values values, EventExecute execute) throws Exception {
        WorkEvent work = WorkEvent.begun();
        try {
            performWhenReady(number, step, values, execute);
        } finally {
            WorkEvent.ended(work, books.flight().converter(), WorkEvent.Kind.SEND, step);
        }
    }

    private void performWhenReady(long number, Step step, Values values, EventExecute execute) throws Exception {
        execute.prepare(step, values);
        if (!driver.rules().table().isOpen(step, knowledge.bindings().with(values))) {
            throw new IllegalStateException("the guards of the original model do not let " + step + " be taken now");
        }
        if (driver.announce(number, execute)) {
            execute.perform(step);
        }
    }

    /** Returns what went wrong. The device has already obeyed, so the other effects are still run. */
    private String run(String effect, Occurrence occurrence, EventExecute execute) throws InterruptedException {
        runningEffect = effect;
        WorkEvent work = WorkEvent.begun();
        try {
            knowledge.bindings().run(effect, occurrence.values());
            return "";
        } catch (InterruptedException stop) {
            throw stop;
        } catch (Exception | LinkageError | AssertionError | StackOverflowError cause) {
            Failure<Occurrence> failure = new Failure<>(execute.name(), "effect " + effect, 0, occurrence, cause);
            books.failures().fault("effect " + effect, failure);
            return failure.toString();
        } finally {
            WorkEvent.ended(work, books.flight().converter(), WorkEvent.Kind.EFFECT, effect);
            runningEffect = "";
        }
    }

    /** The effect that is being run; empty if none is. */
    String runningEffect() {
        return runningEffect;
    }

    /** Carries out directives that belong to no occurrence, such as the beginning and end of visits. */
    void carryOut() {
        carryOut(null);
    }

    /**
     * Carries out what follows an occurrence whose plan was broken off.
     *
     * @param carried its values, if it has led out of the state; else null
     */
    void carryOut(@Nullable Values carried) {
        Agenda agenda = driver.agenda();
        for (Output.Directive next = agenda.poll(); next != null; next = agenda.poll()) {
            visit(next, carried);
        }
        books.transcript().say();
    }

    /** @param carried the values of the event with which a state is entered; null if it is entered again */
    private void visit(Output.Directive directive, @Nullable Values carried) {
        if (directive instanceof Output.Leave) {
            visits.leave();
        } else if (directive instanceof Output.Enter enter) {
            visits.enter(enter, carried);
        } else if (directive instanceof Output.CarryOver over) {
            visits.carryOver(over);
        } else if (directive instanceof Output.Start start) {
            visits.start(start);
        }
    }
}
