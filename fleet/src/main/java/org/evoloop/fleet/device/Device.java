package org.evoloop.fleet.device;

import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.engine.Core;
import org.evoloop.engine.Output;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Work;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The converter of one device. It decides immediately, and waits only for the answer to an {@link Order}: between two
 * calls either nothing is in progress, or one order is open. Times are nanoseconds since 1970, and never decrease.
 *
 * <p>A guard holds if the occurrence in progress lists it ({@link Occurrence.Heard#holding}).
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class Device {
    /** The value if nothing is due. */
    public static final long NEVER = Deadlines.NONE;

    private static final long NANOS_PER_MILLI = 1_000_000;

    private final DeviceListener listener;
    private final long patienceNanos;
    private final Core core;
    private String model;
    private long sequence;
    private long heard;
    private Order.@Nullable Open open;
    private Order.@Nullable Open lost;
    private @Nullable Pending begun;
    private boolean decided;

    /** What the core wants done next; null if nothing. */
    private Output.@Nullable Directive next;

    private DeviceState state;

    /** A new device of the fleet, at the time {@code atNanos}, in the initial states of its models. */
    public Device(Model model, long patienceNanos, DeviceListener listener, long atNanos) {
        this(model, Past.NONE, patienceNanos, listener, atNanos);
    }

    /** A device that comes to the fleet, perhaps not for the first time, in the initial states of its models. */
    public Device(Model model, Past past, long patienceNanos, DeviceListener listener, long atNanos) {
        this.listener = listener;
        this.patienceNanos = patienceNanos;
        this.model = model.version();
        this.sequence = past.sequence();
        this.core = new Core(model.rules(), new CoreOutputs(), past.visit());
        core.opened(atNanos);
        this.state = now();
        settle();
    }

    /**
     * A device that continues from a stored state.
     *
     * @param model the models of {@code state}
     * @param patienceNanos the time after which an order without an answer is given up
     */
    public Device(Model model, DeviceState state, long patienceNanos, DeviceListener listener) {
        this.listener = listener;
        this.patienceNanos = patienceNanos;
        this.core = new Core(model.rules(), state.snapshot(), new CoreOutputs());
        this.model = state.model();
        this.state = state;
        restore(state);
    }

    /** Becomes another device, as {@link #Device(Model, DeviceState, long, DeviceListener)} would make it. */
    public void become(Model otherModel, DeviceState otherState) {
        core.restore(otherModel.rules(), otherState.snapshot());
        restore(otherState);
    }

    private void restore(DeviceState from) {
        Work work = from.snapshot().work();
        model = from.model();
        sequence = from.sequence();
        heard = from.heard();
        open = from.open();
        lost = from.lost();
        begun = work == null ? null : work.pending();
        decided = begun != null;
        next = null;
        state = from;
    }

    /** Its current state. */
    public DeviceState state() {
        return state;
    }

    private DeviceState now() {
        return new DeviceState(model, sequence, heard, open, lost, core.snapshot());
    }

    /** The version of its models. */
    public String model() {
        return model;
    }

    /** Handles an occurrence, after everything that was due before it. */
    public void observed(Occurrence occurrence) {
        due(occurrence.observedNanos());
        core.observed(occurrence);
        settle();
    }

    /**
     * Whether an occurrence numbered by a gateway is new; marks it as received.
     */
    public boolean isNews(long number) {
        boolean news = number == 0 || number > heard;
        heard = Math.max(heard, number);
        return news;
    }

    /**
     * Handles the answer to an order, after everything that was due before it, so the order may already have been given
     * up. An answer to an order that was already answered or never given is ignored.
     */
    public void answered(Answer answer) {
        due(answer.atNanos());
        Order.Open order = open;
        if (order != null && order.sequence() == answer.sequence()) {
            open = null;
            conclude(order, answer);
        } else if (lost != null && lost.sequence() == answer.sequence()) {
            if (answer.outcome() == Answer.Outcome.SENT) {
                core.sent(lost.occurrence(), false, answer.atNanos());
            }
            lost = null;
        }
        settle();
    }

    private void conclude(Order.Open order, Answer answer) {
        long number = order.occurrence();
        boolean done = answer.outcome() == Answer.Outcome.SENT;
        boolean doubtful = answer.outcome() == Answer.Outcome.IN_DOUBT;
        if (order.kind() == Order.Kind.LOCATE) {
            core.located(number, done ? answer.state() : null, answer.atNanos());
        } else if (order.kind() == Order.Kind.RUN) {
            String why = doubtful ? "it is unknown whether it was run: " + answer.reason() : answer.reason();
            core.effectRun(number, done ? "" : why, answer.atNanos());
        } else if (done) {
            core.sent(number, false, answer.atNanos());
        } else if (doubtful) {
            lost = order;
            core.givenUp(number, answer.reason(), answer.atNanos());
        } else {
            core.failed(number, answer.reason(), answer.atNanos());
        }
    }

    /** Handles everything due by {@code atNanos}, each at its own time, earliest first. */
    public void due(long atNanos) {
        due(atNanos, false);
    }

    /**
     * Handles everything due by {@code atNanos}, earliest first.
     *
     * @param late whether each is handled at {@code atNanos} instead of its own time
     */
    public void due(long atNanos, boolean late) {
        long last = NEVER;
        while (true) {
            Snapshot snapshot = state.snapshot();
            Map.Entry<Event, Long> timer = Deadlines.next(snapshot, core.rules());
            long timerNanos = timer == null ? NEVER : timer.getValue();
            long orderNanos = orderDue(open, patienceNanos);
            long next = Math.min(timerNanos, orderNanos);
            // The core ignores an event that the models lack, so its timer stays due.
            if (next > atNanos || (timerNanos <= orderNanos && next == last)) {
                return;
            }
            long handledNanos = late ? atNanos : next;
            if (timer != null && timerNanos <= orderNanos) {
                core.timerDue(snapshot.visit().number(), timer.getKey(), handledNanos);
                last = next;
            } else {
                giveUp(handledNanos);
            }
            settle();
        }
    }

    private void giveUp(long atNanos) {
        Order.Open order = open;
        if (order != null) {
            String why = "no answer within " + patienceNanos / NANOS_PER_MILLI + " ms after its deadline";
            open = null;
            conclude(order, new Answer(order.sequence(), Answer.Outcome.IN_DOUBT, why, null, atNanos));
        }
    }

    private static long orderDue(Order.@Nullable Open order, long patienceNanos) {
        return order == null ? NEVER : order.deadlineNanos() + patienceNanos;
    }

    /** When the next timer or answer is due; {@link #NEVER} if nothing is, or a timer waits for room in the queue. */
    public long dueNanos() {
        return dueNanos(core.rules(), state, patienceNanos);
    }

    /** Whether anything may be due at a device in {@code state}, at any time. */
    public static boolean mayBeDue(DeviceState state) {
        return state.open() != null || !state.snapshot().visit().deadlines().isEmpty();
    }

    /**
     * As {@link #dueNanos()}, of a stored state.
     *
     * @param rules those of its models
     */
    public static long dueNanos(Rules rules, DeviceState state, long patienceNanos) {
        Map.Entry<Event, Long> timer = Deadlines.next(state.snapshot(), rules);
        return Math.min(orderDue(state.open(), patienceNanos), timer == null ? NEVER : timer.getValue());
    }

    /** Switches to other models if possible; returns the reason if not, else an empty string. */
    public String evolve(Model.Takeover takeover, long atNanos) {
        due(atNanos);
        String hindrance = open == null ? core.hindrance(takeover.swap()) : "an order is not answered yet";
        if (hindrance.isEmpty()) {
            core.evolved(takeover.swap(), Math.max(atNanos, core.nowNanos()));
            model = takeover.next().version();
            settle();
        }
        return hindrance;
    }

    private void settle() {
        decide();
        state = now();
        listener.settled(state, core.rules().table().isNew(core.at().evolved()));
    }

    /** Decides until the queue is empty or an order is open. */
    private void decide() {
        while (open == null) {
            Pending pending = begun;
            if (pending != null && core.isBusy()) {
                proceed(pending);
            } else if (core.hasNext()) {
                begun = null;
                core.ready();
                if (begun == null) {
                    return;
                }
            } else {
                return;
            }
        }
    }

    private void proceed(Pending pending) {
        Predicate<String> holds = holding(pending.occurrence())::contains;
        if (!decided) {
            decided = true;
            Decision decision = core.rules().decide(core.at(), core.steps(), pending, holds);
            core.planned(pending.number(), decision, core.nowNanos());
            return;
        }
        Output.Directive directive = next;
        next = null;
        if (directive instanceof Output.Send send) {
            send(pending, send.step(), holds);
        } else if (directive instanceof Output.Run run) {
            core.running(pending.number());
            order(pending, Order.Kind.RUN, run.effect(), core.at().original());
        } else if (directive instanceof Output.Locate) {
            order(pending, Order.Kind.LOCATE, "", core.at().original());
        } else {
            throw new IllegalStateException(
                    "the core waits for something while " + pending.occurrence() + " is in progress");
        }
    }

    private void send(Pending pending, Step step, Predicate<String> holds) {
        if (!core.rules().table().isOpen(step, holds)) {
            core.failed(
                    pending.number(),
                    "the guards of the original model do not let " + step + " be taken now",
                    core.nowNanos());
            return;
        }
        core.sending(pending.number());
        if (core.maySend(pending.number())) {
            order(pending, Order.Kind.SEND, step.trigger().name(), step.target());
        }
    }

    private void order(Pending pending, Order.Kind kind, String what, State to) {
        sequence++;
        Order order = new Order(
                sequence,
                pending.number(),
                kind,
                what,
                pending.occurrence().values(),
                core.nowNanos() + patienceNanos,
                core.visit(),
                !core.isVisitOver(),
                core.at().original().name(),
                to.name());
        open = Order.Open.of(order);
        listener.ordered(order);
    }

    private static Set<String> holding(Occurrence occurrence) {
        return occurrence instanceof Occurrence.Heard heard ? heard.holding() : Set.of();
    }

    /** Receives the outputs of the core; what runs during a visit, and what is only logged, has no place in a fleet. */
    private final class CoreOutputs implements Outputs {
        @Override
        public void begin(Pending pending) {
            begun = pending;
            decided = false;
            next = null;
        }

        @Override
        public void say(Output output) {
            if (output instanceof Output.Directive directive) {
                next = directive;
            } else if (output instanceof Output.Notice notice) {
                listener.noted(notice);
            }
        }

        @Override
        public void leave() {}

        @Override
        public void enter(long visit, State state, @Nullable Transition by, Map<Event, Long> deadlines) {}

        @Override
        public void carryOver(long visit, State state, Map<Event, Long> deadlines) {}

        @Override
        public void settle(Configuration now) {}

        @Override
        public void start(long visit, boolean again) {}

        @Override
        public void queued(Occurrence occurrence) {}

        @Override
        public void decided(Pending pending, Decision decision, long waitedNanos) {}

        @Override
        public void overtaken(Occurrence occurrence, String why) {}

        @Override
        public void took(Step step) {}

        @Override
        public void moved(Configuration before, Configuration after) {}
    }
}
