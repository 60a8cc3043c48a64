package org.evoloop.converter.edge;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.evoloop.converter.Analysis;
import org.evoloop.converter.ChangePlan;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.EventPlan;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.converter.attachment.ExecuteAccess;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.KnowledgeAccess;
import org.evoloop.converter.attachment.UserCode;
import org.evoloop.converter.binding.Bindings;
import org.evoloop.converter.recording.FailureLog;
import org.evoloop.converter.recording.Transcript;
import org.evoloop.converter.running.Assembly;
import org.evoloop.converter.running.CurrentKnowledge;
import org.evoloop.converter.running.Visits;
import org.evoloop.engine.Output;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Component;
import org.evoloop.loop.Dispatch;
import org.evoloop.loop.Failure;
import org.evoloop.loop.Intake;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.QueueStatus;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * A converter without its core: the monitors, execute components and new functions of a device whose events are decided
 * elsewhere, such as in a fleet. Observations go to a {@link Decider}; its decisions are carried out by {@link #send},
 * {@link #run}, {@link #locate} and {@link #stand}.
 *
 * <p>Lifecycle: add the components, {@link #open}, {@link #close}.
 *
 * <p>Threading: those that add, {@code open} and {@code close} for one thread. The methods that carry out decisions wait for the
 * device, and are for one thread, too.
 *
 * @since 0.1
 */
public final class EdgeShell implements AutoCloseable {
    private final LoopConfig config;
    private final StateKnowledge knowledge;
    private final KnowledgeAccess access;
    private final Decider decider;
    private final FailureLog failures;
    private final Visits visits;
    /** Those of both models, by the events that they guard. */
    private final Map<Event, Set<String>> guards;

    /** All of them: what is sent for an event may have guards of its own. */
    private final Set<String> all = new TreeSet<>();

    private final Assembly assembly = new Assembly();
    private final MapeLoop<Occurrence, Analysis, ChangePlan> loop;
    private final ExecuteAccess.Host host = new Host();
    private volatile Configuration at;

    /** The sequence number of what was asked for and is not answered; 0 if nothing is. */
    private long asked;

    /** The last visit that has begun, or ended before it began. */
    private long visited;

    /** Who decides. Called on any thread, one call at a time for what comes from one thread; must be quick. */
    public interface Decider {
        /** Something was observed, or a function has raised it. */
        void observed(Occurrence occurrence);

        /**
         * Something that was asked for came to its end.
         *
         * @param reason why it was not done, for people; else empty
         * @param state where the device is, if it was asked and knows
         */
        void answered(long sequence, Result result, String reason, Optional<State> state);
    }

    /** What became of something that was asked for. */
    public enum Result {
        /** It was done. */
        SENT,
        /** It was not done, and will not be. */
        FAILED,
        /** It is unknown whether it took effect. */
        IN_DOUBT
    }

    /**
     * The states of device and evolved system, by what was decided.
     *
     * @param visit the number of the evolved system's stay in its state
     * @param settled whether nothing is in progress
     * @param function whether the state's function is to run; it may have to wait, and begin later in the same visit
     * @param from the state that was left for this one; empty if that is unknown
     * @param by the event with which it was left, with its guards; empty if that is unknown
     */
    public record Standing(Configuration at, long visit, boolean settled, boolean function, String from, String by) {}

    /** One without components. */
    public EdgeShell(LoopConfig config, StateKnowledge knowledge, Decider decider) {
        this.config = config;
        this.knowledge = knowledge;
        this.access = Friends.KNOWLEDGE.of(knowledge);
        this.decider = decider;
        this.failures = new FailureLog(config);
        this.visits = new Visits(config, new CurrentKnowledge(knowledge), new Transcript(config.name()), failures);
        this.at = knowledge.models().initial();
        this.guards = Bindings.byEvent(knowledge.models().original());
        Bindings.byEvent(knowledge.models().evolved())
                .forEach((event, drawn) -> guards.merge(event, drawn, EdgeShell::union));
        guards.values().forEach(all::addAll);
        this.loop = new MapeLoop<>(config, new Failures(), Dispatch.toEach(), new ReportIntake());
    }

    private static Set<String> union(Set<String> one, Set<String> other) {
        Set<String> both = new TreeSet<>(one);
        both.addAll(other);
        return both;
    }

    /** Adds a monitor; what it reports goes to the decider at once, on the thread that reports it. */
    public void addMonitor(EventMonitor monitor) {
        assembly.add(monitor);
    }

    /** Adds a component that sends events. */
    public void addExecute(EventExecute execute) {
        assembly.add(execute);
    }

    private static void decidedElsewhere(Occurrence occurrence, Object then) {
        throw new UnsupportedOperationException(
                occurrence.label() + " is decided elsewhere, which does not report the outcome; use press instead");
    }

    /**
     * Begins to observe.
     *
     * @throws org.evoloop.statemachine.ModelException if the models and the components do not fit; the message lists all problems
     */
    public void open() {
        DecisionTable table = assembly.compile(knowledge, true);
        access.bindings().watch(config, failures::fault);
        Supplier<Configuration> place = () -> at;
        access.attach(place);
        visits.attach(loop, EdgeShell::decidedElsewhere);
        loop.addAnalyze(new EventAnalyze());
        loop.addPlan(new EventPlan());
        for (Component component : assembly.all()) {
            if (component instanceof EventMonitor monitor) {
                // Guards are evaluated once for each event, by observed().
                Friends.MONITOR
                        .of(monitor)
                        .attach(
                                config,
                                loop,
                                access.eventNames(),
                                (event, values) -> Set.of(),
                                table::isDevicesOwn,
                                EdgeShell::decidedElsewhere);
                loop.addMonitor(monitor);
            } else if (component instanceof EventExecute execute) {
                Friends.EXECUTE.of(execute).attach(host, config);
                loop.addExecute(execute);
            }
        }
        loop.buildAndStart();
    }

    // What was decided

    /** Sends {@code step} to the device. The answer comes when it has taken effect, maybe before this returns. */
    public void send(long sequence, Step step, Values values) throws InterruptedException {
        for (ExecuteAccess execute : executes()) {
            if (execute.events().contains(step.trigger())) {
                carryOut(sequence, execute.name(), "send", () -> {
                    execute.carry(values);
                    execute.awaitReady(step);
                    synchronized (this) {
                        execute.setSending(sequence);
                    }
                    execute.send(step);
                    execute.sendReturned();
                });
                return;
            }
        }
        decider.answered(sequence, Result.FAILED, "nothing here can send " + step.trigger(), Optional.empty());
    }

    /** Runs an effect of the new model. */
    public void run(long sequence, String effect, Values values) throws InterruptedException {
        carryOut(sequence, "effect", effect, () -> {
            access.bindings().run(effect, values);
            answer(sequence, Result.SENT, "", Optional.empty());
        });
    }

    /** Asks the device where it is. */
    public void locate(long sequence) throws InterruptedException {
        List<ExecuteAccess> executes = executes();
        carryOut(sequence, "device", "locate", () -> {
            Optional<State> found = Optional.empty();
            for (int index = 0; index < executes.size() && found.isEmpty(); index++) {
                ExecuteAccess execute = executes.get(index);
                boolean isLast = index == executes.size() - 1;
                found = execute.locate(access::located, isLast, cause -> failed(execute, "locate", cause));
            }
            answer(sequence, Result.SENT, "", found);
        });
    }

    private void carryOut(long sequence, String who, String what, UserCode.Call work) throws InterruptedException {
        synchronized (this) {
            asked = sequence;
        }
        Throwable cause = UserCode.call(work);
        if (cause != null) {
            Failure<Occurrence> failure = new Failure<>(who, what, 0, null, cause);
            failures.log(failure);
            boolean unknown = cause instanceof UnknownEffectException;
            answer(sequence, unknown ? Result.IN_DOUBT : Result.FAILED, failure.toString(), Optional.empty());
        }
    }

    /** Answers the current request; later answers to it are ignored. */
    private synchronized void answer(long sequence, Result result, String reason, Optional<State> state) {
        if (asked == sequence) {
            asked = 0;
            decider.answered(sequence, result, reason, state);
        }
    }

    private synchronized void tookEffect(ExecuteAccess execute) {
        if (execute.sending() != 0) {
            answer(execute.sending(), Result.SENT, "", Optional.empty());
            execute.setSending(0);
        }
    }

    private List<ExecuteAccess> executes() {
        return assembly.executes().stream().map(Friends.EXECUTE::of).toList();
    }

    private final class Host implements ExecuteAccess.Host {
        @Override
        public void carryOut(Occurrence occurrence, Decision plan, ExecuteAccess execute) {
            // The loop here makes no plans.
        }

        @Override
        public void tookEffect(ExecuteAccess execute, boolean inOrder) {
            EdgeShell.this.tookEffect(execute);
        }
    }

    /** The visit {@code visit} has ended, or will not begin; so do its function and its timers. */
    public void leave(long visit) {
        if (visit >= visited) {
            visited = visit;
            visits.leave();
        }
    }

    /** Takes over the present states of device and evolved system; replaces all that was given before. */
    public void stand(Standing now) {
        at = now.at();
        State state = now.at().evolved();
        if (now.visit() > visited || !now.function()) {
            leave(now.visit() > visited ? now.visit() - 1 : now.visit());
        }
        if (!knowledge.models().evolved().hasState(state)) {
            failures.warn("the models here have no state " + state
                    + ", which was decided elsewhere; start this program with the" + " models that are used there");
            return;
        }
        if (now.settled()) {
            executes().forEach(execute -> settle(execute, now.at()));
        }
        if (now.function() && now.visit() > visited) {
            visited = now.visit();
            visits.enter(new Output.Enter(now.visit(), state, transition(now), Map.of()), Values.NONE, false);
            visits.start(new Output.Start(now.visit(), false));
        }
    }

    private void settle(ExecuteAccess execute, Configuration now) {
        tell(execute, "settled", () -> execute.settled(now));
    }

    private void tell(ExecuteAccess execute, String phase, UserCode.Call call) {
        try {
            Throwable cause = UserCode.call(call);
            if (cause != null) {
                failed(execute, phase, cause);
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    private void failed(ExecuteAccess execute, String phase, Throwable cause) {
        failures.log(new Failure<>(execute.name(), phase, 0, null, cause));
    }

    /** The transition that led to the state, which names its function. */
    private @Nullable Transition transition(Standing now) {
        Transition likely = null;
        for (Transition each : knowledge.models().evolved().transitions()) {
            if (each.target().equals(now.at().evolved()) && !each.internal()) {
                if (each.source().name().equals(now.from())
                        && each.event().toString().equals(now.by())) {
                    return each;
                }
                likely = likely == null ? each : likely;
            }
        }
        return likely;
    }

    // What is observed

    private void observed(Occurrence occurrence) {
        Set<String> holding = occurrence instanceof Occurrence.Heard heard
                ? access.bindings().holding(all, guards.getOrDefault(heard.event(), Set.of()), heard.values())
                : Set.of();
        if (occurrence instanceof Occurrence.Heard heard && !holding.isEmpty()) {
            decider.observed(new Occurrence.Heard(
                    heard.event(),
                    heard.values(),
                    heard.source(),
                    heard.deviceActed(),
                    holding,
                    heard.visit(),
                    heard.observedNanos()));
        } else {
            decider.observed(occurrence);
        }
    }

    /** Queues nothing: the decider has a queue. */
    private final class ReportIntake implements Intake<Occurrence> {
        @Override
        public Admission atOnce(Occurrence occurrence) {
            observed(occurrence);
            return Admission.TAKEN;
        }

        @Override
        public Admission offer(Occurrence occurrence) {
            return atOnce(occurrence);
        }

        @Override
        public boolean hasRoom(Occurrence occurrence) {
            return true;
        }

        @Override
        public @Nullable Occurrence next() {
            return null;
        }

        @Override
        public void ended() {}

        @Override
        public void opened() {}

        @Override
        public void closed() {}

        @Override
        public QueueStatus status() {
            return new QueueStatus(0, 0, 0, 0, 0, 0);
        }
    }

    private final class Failures implements LoopListener<Occurrence> {
        @Override
        public void failed(Failure<Occurrence> failure) {
            failures.log(failure);
        }

        @Override
        public void dropped(Occurrence occurrence, boolean first) {}
    }

    /** Ends the function that runs and the monitors, and lets go of the device. Idempotent. */
    @Override
    public void close() {
        visits.leave();
        loop.close();
        for (ExecuteAccess execute : executes()) {
            tell(execute, "released", execute::released);
        }
    }
}
