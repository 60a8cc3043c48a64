package org.evoloop.converter.running;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.attachment.Endings;
import org.evoloop.converter.recording.FailureLog;
import org.evoloop.converter.recording.Transcript;
import org.evoloop.engine.Output;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.flight.WorkEvent;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.function.visit.FunctionRunner;
import org.evoloop.function.visit.HostedVisit;
import org.evoloop.function.visit.VisitHost;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.MapeLoop;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Carries out the core's directives for visits: sets their timers, runs their functions, and hands the events that they
 * raise to the loop.
 *
 * <p>Threading: states are entered and left by one thread at a time, under this object's lock; visits and the clock
 * call from their own threads.
 */
public final class Visits implements VisitHost {
    private static final Duration FIRST_PAUSE = Duration.ofMillis(100);

    /** The pause grows up to 3.2 s. */
    private static final int MOST_DOUBLINGS = 5;

    private final LoopConfig config;
    private final CurrentKnowledge knowledge;
    private final Transcript transcript;
    private final FailureLog failures;
    private final FunctionRunner functions;
    private @Nullable MapeLoop<Occurrence, ?, ?> loop;
    private volatile @Nullable Endings endings;
    private @Nullable HostedVisit current;

    /** The state of the current visit, in terms of the present models. */
    private @Nullable State present;

    /** Whether other models have taken over since the current visit began. */
    private boolean takenOver;

    private NewFunction function = NewFunction.none();
    private Map<Event, Long> deadlines = Map.of();

    /** The wall-clock times of the deadlines asked for, so that each stays the same although the two clocks drift. */
    private final Map<Event, Instant> dues = new HashMap<>();

    private int retries;
    private volatile @Nullable WorkEvent recorded;

    public Visits(LoopConfig config, CurrentKnowledge knowledge, Transcript transcript, FailureLog failures) {
        this.config = config;
        this.knowledge = knowledge;
        this.transcript = transcript;
        this.failures = failures;
        this.functions = new FunctionRunner(this, config.joinLimit());
    }

    /** Sets the loop that takes the raised events; before the first visit. */
    public void attach(MapeLoop<Occurrence, ?, ?> joined, Endings ends) {
        endings = ends;
        loop = joined;
    }

    /**
     * Begins a visit, unless another has already followed it.
     *
     * @param carried the values of the event with which the state is entered; null if it is entered again
     * @param anew whether that is because the converter has been started, or other models have taken over
     */
    public synchronized void enter(Output.Enter enter, @Nullable Values carried, boolean anew) {
        Visit before = current;
        if (before != null && before.number() >= enter.visit()) {
            return;
        }
        Values values = carried == null ? valuesBefore(enter.state()) : carried;
        Visit.Beginning beginning = carried != null ? Visit.Beginning.NEW : beginning(before, anew);
        HostedVisit entered = new HostedVisit(enter.state(), beginning, enter.visit(), values, this);
        functions.begin(entered);
        current = entered;
        takenOver = false;
        present = enter.state();
        Transition by = enter.by();
        function = by == null ? NewFunction.none() : knowledge.access().action(by);
        set(Map.of(), enter.deadlines(), entered);
    }

    /** Of a state that is entered again. */
    private Visit.Beginning beginning(@Nullable Visit before, boolean anew) {
        if (takenOver) {
            return Visit.Beginning.TAKEN_OVER;
        }
        return anew || before == null ? Visit.Beginning.RESUMED : before.beginning();
    }

    private Values valuesBefore(State again) {
        Visit before = current;
        return before != null && again.equals(present) ? before.values() : Values.NONE;
    }

    /** Other models have taken over, whose {@code state} succeeds that of the current visit, continued or not. */
    synchronized void becomes(State state) {
        present = state;
        takenOver = true;
    }

    /** Continues the current visit and its function in a state of other models. */
    synchronized void carryOver(Output.CarryOver over) {
        HostedVisit goingOn = current;
        if (goingOn != null && goingOn.number() == over.visit()) {
            goingOn.goOnIn(over.state());
            set(deadlines, over.deadlines(), goingOn);
        }
    }

    /** Sets the missing timers. Cancelled ones still fire; the core ignores them. */
    private void set(Map<Event, Long> before, Map<Event, Long> now, HostedVisit visit) {
        deadlines = now;
        if (!dues.isEmpty()) {
            dues.keySet().retainAll(now.keySet());
        }
        if (now.isEmpty()) {
            return;
        }
        long nanos = config.clock().nanoTime();
        for (Map.Entry<Event, Long> timer : now.entrySet()) {
            if (!timer.getValue().equals(before.get(timer.getKey()))) {
                Duration left = Duration.ofNanos(Math.max(0, timer.getValue() - nanos));
                dues.remove(timer.getKey());
                visit.onClock(left, () -> fire(visit, timer.getKey()));
            }
        }
    }

    private void fire(Visit visit, Event event) {
        offer(raised(visit, event, Values.NONE, Source.TIMER));
    }

    /**
     * Runs the function of the entered state, if that has not been left meanwhile. If the state could not be left, the
     * function is restarted, at once and then after growing pauses, since it may end as soon as it has begun.
     */
    public synchronized void start(Output.Start start) {
        HostedVisit entered = current;
        if (entered == null || entered.number() != start.visit()) {
            return;
        }
        retries = start.again() ? retries + 1 : 0;
        if (retries <= 1) {
            run();
        } else {
            int doublings = Math.min(retries - 2, MOST_DOUBLINGS);
            entered.onClock(FIRST_PAUSE.multipliedBy(1L << doublings), () -> startLate(entered));
        }
    }

    private synchronized void startLate(Visit entered) {
        if (entered == current) {
            run();
        }
    }

    private void run() {
        recorded = WorkEvent.begun();
        functions.run(function);
    }

    /** Ends the function of the current visit, whose state is about to be left. */
    public void leave() {
        Visit left = functions.running();
        WorkEvent ended = recorded;
        functions.end();
        if (left != null && ended != null) {
            WorkEvent.ended(ended, config.name(), WorkEvent.Kind.FUNCTION, left.state());
            recorded = recorded == ended ? null : recorded;
        }
    }

    boolean ownsCurrentThread() {
        return functions.ownsCurrentThread();
    }

    /** The progress of the running function, which is about to be left; empty if none runs or it reports none. */
    String leaving() {
        Visit running = functions.running();
        // Most functions report none, and a string would be garbage in every event.
        return running == null
                        || (running.progress().isEmpty() && running.readings().isEmpty())
                ? ""
                : "left " + running.state() + " at " + runningFunction().describe();
    }

    ConverterStatus.RunningFunction runningFunction() {
        Visit running = functions.running();
        if (running == null) {
            return ConverterStatus.RunningFunction.NONE;
        }
        return new ConverterStatus.RunningFunction(
                running.state().name(), functions.threadName(), running.progress(), running.readings());
    }

    /**
     * The timers that run, the next one first.
     *
     * @param running their deadlines
     */
    synchronized List<ConverterStatus.RunningTimer> runningTimers(Map<Event, Long> running) {
        long nanos = config.clock().nanoTime();
        List<ConverterStatus.RunningTimer> timers = new ArrayList<>();
        running.forEach((event, deadline) -> {
            if (deadlines.containsKey(event)) {
                Duration remaining = Duration.ofNanos(Math.max(0, deadline - nanos));
                Instant due = dues.computeIfAbsent(
                        event, asked -> config.clock().wallTime().plus(remaining));
                timers.add(new ConverterStatus.RunningTimer(event.name(), remaining, due));
            }
        });
        timers.sort(Comparator.comparing(ConverterStatus.RunningTimer::remaining));
        return timers;
    }

    @Override
    public State device() {
        return knowledge.get().getOriginalState();
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
        return knowledge.get().models().evolved().hasTransition(asking.state(), event);
    }

    @Override
    public void requireKnown(Event event) {
        knowledge.access().eventNames().require(event);
    }

    @Override
    public void requireNotDeferred(Visit raising, Event event) {
        if (knowledge.get().models().evolved().defers(raising.state(), event)) {
            throw new IllegalArgumentException(
                    raising.state() + " defers " + event
                            + ", so that its own function cannot raise it: it would wait for another state, where it is too late");
        }
    }

    @Override
    public String unexpected(Visit finishing, Event event) {
        StateMachine evolved = knowledge.get().models().evolved();
        if (evolved.hasTrigger(finishing.state(), event)) {
            return "";
        }
        List<String> known = evolved.transitionsFrom(finishing.state()).stream()
                .map(transition -> transition.event().trigger().name())
                .distinct()
                .toList();
        return finishing.state() + " has no transition for " + event + ", with which its function ends"
                + Names.hint(event.name(), known);
    }

    @Override
    public void raise(Visit raising, Event event, Values values) throws InterruptedException {
        put(raised(raising, event, values, Source.FUNCTION));
    }

    @Override
    public void send(Visit asking, Event event, Values values) throws InterruptedException {
        put(new Occurrence.Asked(event, values, asking.number(), config.clock().nanoTime()));
    }

    @Override
    public void ask(Visit asking, Event event, Values values, Consumer<EventOutcome> then) {
        Endings told = endings;
        MapeLoop<Occurrence, ?, ?> joined = loop;
        if (told == null || joined == null) {
            then.accept(new EventOutcome.Refused("the converter is not built yet"));
            return;
        }
        Occurrence asked = new Occurrence.Asked(
                event, values, asking.number(), config.clock().nanoTime());
        told.await(asked, then);
        joined.offer(asked);
    }

    private void put(Occurrence occurrence) throws InterruptedException {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        if (joined != null) {
            joined.put(occurrence);
        }
    }

    private void offer(Occurrence occurrence) {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        if (joined != null) {
            joined.offer(occurrence);
        }
    }

    @Override
    public void finish(Visit finishing, Event event, Values values) {
        offer(raised(finishing, event, values, Source.FUNCTION));
    }

    private Occurrence raised(Visit raising, Event event, Values values, Source source) {
        return new Occurrence.Heard(
                event, values, source, raising.number(), config.clock().nanoTime());
    }

    @Override
    public void notice(String line) {
        transcript.notice(line);
    }

    @Override
    public void failed(Visit failing, Throwable cause) {
        String state = failing.state().name();
        failures.fault("function " + state, new Failure<>(state, "function", 0, null, cause));
    }
}
