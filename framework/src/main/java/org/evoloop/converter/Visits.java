package org.evoloop.converter;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.function.FunctionRunner;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.function.VisitHost;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.MapeLoop;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The visits of states, one after the other: the timers and the function of the current one, and what it raises.
 *
 * <p>Threading: states are entered and left by one thread at a time, under this object's lock; visits and the clock call
 * from their own threads, and only hand to the loop's queue what they raise.
 */
final class Visits implements VisitHost {
    private final LoopConfig config;
    private final StateKnowledge knowledge;
    private final MapeLoop<Occurrence, ?, ?> loop;
    private final Transcript transcript;
    private final FailureLog failures;
    private final FunctionRunner functions;
    private volatile @Nullable Visit current;
    private long count;

    /** When the timers of the current visit fire; one that has been heard is no longer in it. */
    private final Map<Event, Long> deadlines = new HashMap<>();

    /** What runs in the current state if it is a new one: the function of the transition that led there. */
    private NewFunction function = NewFunction.none();

    Visits(
            LoopConfig config,
            StateKnowledge knowledge,
            MapeLoop<Occurrence, ?, ?> loop,
            Transcript transcript,
            FailureLog failures) {
        this.config = config;
        this.knowledge = knowledge;
        this.loop = loop;
        this.transcript = transcript;
        this.failures = failures;
        this.functions = new FunctionRunner(this, config.joinLimit());
    }

    /** Whether an earlier visit than the current one has raised it. */
    boolean isStale(Occurrence occurrence) {
        Visit now = current;
        return occurrence.visit() != Occurrence.ANY_VISIT && (now == null || occurrence.visit() != now.number());
    }

    /**
     * Begins a visit.
     *
     * @param kept names of time triggers that go on from the visit before, since a state around both is not left
     */
    synchronized Visit enter(State state, NewFunction toRun, Set<String> kept) {
        Visit entered = new Visit(state, ++count, this);
        functions.begin(entered);
        current = entered;
        function = toRun;
        Map<Event, Duration> timers = knowledge.timersOf(state);
        if (timers.isEmpty() && deadlines.isEmpty()) {
            return entered;
        }
        deadlines.keySet().removeIf(event -> !kept.contains(event.name()));
        long now = config.clock().nanoTime();
        timers.forEach((event, delay) -> {
            if (kept.contains(event.name()) && !deadlines.containsKey(event)) {
                // It has been heard in an earlier visit of the state around.
                return;
            }
            long deadline = deadlines.computeIfAbsent(event, key -> now + delay.toNanos());
            entered.after(Duration.ofNanos(Math.max(0, deadline - now)), () -> fire(event, entered));
        });
        return entered;
    }

    private void fire(Event event, Visit raising) {
        loop.offer(raisedBy(raising, event, Source.TIMER));
    }

    /** The event of a timer has come round. */
    synchronized void heard(Event timer) {
        deadlines.remove(timer);
    }

    /** Runs the function of a new state that was entered, if it has not been left meanwhile. */
    synchronized void startFunction(@Nullable Visit entered) {
        if (entered != null && entered == current && knowledge.models().isNew(entered.state())) {
            functions.run(function);
        }
    }

    /** Enters the current state anew, as after a start or an attempt to leave it that failed. */
    synchronized void enterAgain() {
        startFunction(enter(knowledge.getCurrentState(), function, Set.of()));
    }

    /** Ends what runs in the current visit, whose state will be left. */
    void endFunction() {
        functions.end();
    }

    /** Ends the current visit; no other follows until the next is entered. */
    synchronized void leave() {
        functions.end();
        current = null;
    }

    boolean ownsCurrentThread() {
        return functions.ownsCurrentThread();
    }

    ConverterStatus.RunningFunction runningFunction() {
        Visit running = functions.running();
        return new ConverterStatus.RunningFunction(
                running == null ? "" : running.state().name(), functions.threadName());
    }

    @Override
    public Clock clock() {
        return config.clock();
    }

    @Override
    public boolean threads() {
        return config.threads();
    }

    @Override
    public boolean accepts(Visit asking, Event event) {
        return knowledge.models().evolved().hasTransition(asking.state(), event);
    }

    @Override
    public void requireKnown(Event event) {
        knowledge.eventNames().require(event);
    }

    @Override
    public void raise(Visit raising, Event event) throws InterruptedException {
        loop.put(raisedBy(raising, event, Source.FUNCTION));
    }

    @Override
    public void finish(Visit finishing, Event event) {
        loop.offer(raisedBy(finishing, event, Source.FUNCTION));
    }

    private Occurrence raisedBy(Visit raising, Event event, Source source) {
        return new Occurrence(
                event, source, false, raising.number(), config.clock().nanoTime());
    }

    @Override
    public void notice(String line) {
        transcript.notice(line);
    }

    @Override
    public void failed(Visit failing, Throwable cause) {
        failures.log(new Failure<>(failing.state().name(), "function", 0, null, cause));
    }
}
