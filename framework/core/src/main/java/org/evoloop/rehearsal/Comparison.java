package org.evoloop.rehearsal;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.evoloop.engine.Core;
import org.evoloop.engine.Doubt;
import org.evoloop.engine.Input;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Reframed;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Gives other models the inputs of a converter, and compares both decisions on each event.
 *
 * <p>The other models' core gets each input of the converter's core, as long as both do the same: what is sent, fails,
 * is given up, comes in between, or finds no room is so for both, and equal models never differ. Where the other models
 * plan otherwise for an event, they carry that out when the event has ended in the converter: each of their steps and
 * effects succeeds at once, unless one for the same event failed there. A guard holds if it held there. A timer that
 * both have, due at the same time, fires when the converter's does; any other when it is due. An event of a function
 * occurs only while both new models are in the same state.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class Comparison {
    private final Compared compared;
    private final Consumer<Ending> endings;
    private final Chronicle converter = new Chronicle(this::ended);

    private final Pairs pairs = new Pairs();

    /** How occurrences ended in the converter that have not ended in the other models; by the converter's numbers. */
    private final Map<Long, Optional<Ending>> then = new HashMap<>();

    /** How occurrences ended in the other models that have not ended in the converter; by their numbers. */
    private final Map<Long, Optional<Ending>> early = new HashMap<>();

    /** What has ended in the converter with the present input. */
    private final List<Over> over = new ArrayList<>();

    private @Nullable Beside beside;

    /** An occurrence has ended in the converter; its number is 0 if it never was in progress. */
    private record Over(long number, @Nullable Ending ending) {}

    /** Receives the comparison of an event. */
    @FunctionalInterface
    public interface Compared {
        /**
         * An event was handled by both, or by one of the two.
         *
         * @param then the converter's verdict; null for a timer that it does not have
         * @param now the other models' verdict; null if it would not have happened
         */
        void compared(Occurrence occurrence, @Nullable Verdict then, @Nullable Verdict now);
    }

    /** @param endings receives every event that the other models have handled */
    public Comparison(Compared compared, Consumer<Ending> endings) {
        this.compared = compared;
        this.endings = endings;
    }

    /** Receives the outputs of the converter's core. */
    public Outputs hears() {
        return converter;
    }

    /**
     * The other models begin beside a converter between two events.
     *
     * @param recorded the converter's core
     * @param from the other models' state; what waits there has the converter's numbers
     */
    public void begin(Core recorded, Rules rules, Snapshot from) {
        pairs.clear();
        then.clear();
        early.clear();
        over.clear();
        Set<Long> waiting = Pairs.open(recorded);
        for (Pending pending : from.waiting()) {
            if (waiting.contains(pending.number())) {
                pairs.add(pending.number(), pending.number());
            }
        }
        Rehearsal other = new Rehearsal(rules, from, this::recordedOf, this::otherEnded);
        beside = new Beside(recorded, other, from.doubt());
    }

    /** Whether the other models have begun. */
    public boolean hasBegun() {
        return beside != null;
    }

    /** Another core continues the converter's in the same state. */
    public void continues(Core recorded) {
        Beside present = beside();
        present.recorded = recorded;
        converter.follow(recorded);
        present.look();
    }

    /** The other models continue by these rules, since the converter's components have changed. */
    public void use(Rules rules, long atNanos) {
        beside().other.use(rules, atNanos);
    }

    /**
     * Another process continues, on a clock that is {@code nanos} ahead; next is its {@link Input.Recovered}.
     *
     * @param recorded the converter's core with its times on that clock
     */
    public void restarts(Core recorded, Rules rules, long nanos) {
        beside().other.restart(rules, nanos);
        continues(recorded);
    }

    private Beside beside() {
        if (beside == null) {
            throw new IllegalStateException("it has not begun");
        }
        return beside;
    }

    /** The states in which device and evolved system would be. */
    public Configuration at() {
        return beside().other.at();
    }

    /** The converter's core has received this input. */
    public void took(Input input) {
        Beside present = beside();
        present.took(input);
        present.look();
    }

    /** The converter's core has received an input that does not count for other models. */
    public void missed() {
        over.clear();
        beside().look();
    }

    /** Time has passed: timers that only the other models have get their turns. */
    public void pass(long atNanos) {
        beside().fire(atNanos);
    }

    /**
     * The comparison ends, if it has begun; another can begin. What the other models have not handled yet, they would not
     * have handled.
     */
    public void end() {
        List.copyOf(then.values()).forEach(ending -> compare(ending.orElse(null), null));
        beside = null;
    }

    private void part(long number) {
        Long others = pairs.remove(number);
        if (others != null) {
            early.remove(others);
        }
    }

    private @Nullable Ending recordedOf(long others) {
        Long number = pairs.converters(others);
        Optional<Ending> ending = number == null ? null : then.get(number);
        return ending == null ? null : ending.orElse(null);
    }

    private void ended(long number, @Nullable Ending ending) {
        over.add(new Over(number, ending));
    }

    private void otherEnded(long number, @Nullable Ending ending) {
        if (ending != null) {
            endings.accept(ending);
        }
        Rehearsal other = beside().other;
        if (other.isObserving()) {
            early.put(other.observed(), Optional.ofNullable(ending));
            return;
        }
        Long recorded = pairs.converters(number);
        if (recorded == null) {
            if (ending != null && isTimer(ending) && number > 0) {
                compared.compared(ending.ended().occurrence(), null, ending.verdict());
            }
        } else if (then.containsKey(recorded)) {
            Optional<Ending> ended = then.remove(recorded);
            part(recorded);
            compare(ended.orElse(null), ending);
        } else {
            early.put(number, Optional.ofNullable(ending));
        }
    }

    private static boolean isTimer(Ending ending) {
        return ending.ended().occurrence().source() == Source.TIMER;
    }

    private void compare(@Nullable Ending ended, @Nullable Ending answer) {
        if (ended == null || ended.ended().outcome() == Outcome.STALE) {
            return;
        }
        Verdict now = answer != null ? answer.verdict() : isNoNews(ended) ? ended.verdict() : null;
        compared.compared(ended.ended().occurrence(), ended.verdict(), now);
    }

    /** Whether the device was found, and the other models are where that led: they have no doubts. */
    private boolean isNoNews(Ending ending) {
        return ending.ended().occurrence() instanceof Occurrence.Found
                && ending.ended().after().equals(at());
    }

    /** The converter's core and the other models'. */
    private final class Beside {
        private final Rehearsal other;
        private Core recorded;
        private Earlier earlier;

        /** Whether both carry out the same plan for the same occurrence, or have yet to decide about it. */
        private boolean inStep;

        /** The occurrence about whose step the converter was in doubt last; 0 if the other models were not. */
        private long doubted;

        private long othersDoubted;

        /** @param doubt the doubt in which the other models begin, about a step of the converter's; null for none */
        Beside(Core recorded, Rehearsal other, @Nullable Doubt doubt) {
            this.recorded = recorded;
            this.other = other;
            this.doubted = doubt == null ? 0 : doubt.number();
            this.othersDoubted = doubted;
            converter.follow(recorded);
            converter.look();
            this.earlier = Earlier.of(recorded, converter);
        }

        void look() {
            converter.look();
            other.look();
            earlier = Earlier.of(recorded, converter);
        }

        void took(Input input) {
            long at = recorded.nowNanos();
            fire(at);
            long others = inStep ? Plans.numberOf(other.begun()) : 0;
            give(input, others, at);
            other.isAt(at);
            if (converter.isInDoubtAnew() && earlier.number() > 0 && isAbout(input, earlier.number())) {
                doubted = others == 0 ? 0 : earlier.number();
                othersDoubted = others;
            }
            inStep &= Plans.numberOf(converter.begun()) > 0
                    && Objects.equals(pairs.others(Plans.numberOf(converter.begun())), Plans.numberOf(other.begun()))
                    && recorded.isBusy()
                    && other.core.isBusy();
            List<Over> ended = List.copyOf(over);
            over.clear();
            ended.forEach(each -> isOver(each, input, at));
            if (recorded.tally().stale() > earlier.tally().stale()
                    || recorded.tally().refused() > earlier.tally().refused()) {
                forgetWhatIsGone();
            }
            settle(at);
        }

        private static boolean isAbout(Input input, long number) {
            return input instanceof Input.Recovered || Plans.numberOf(input) == number;
        }

        private void give(Input input, long others, long at) {
            if (input instanceof Input.Opened
                    || input instanceof Input.Closing
                    || input instanceof Input.Closed
                    || input instanceof Input.Recovered) {
                other.core.apply(input);
            } else if (input instanceof Input.Observed observed) {
                observe(observed.occurrence());
            } else if (input instanceof Input.TimerDue timer) {
                fires(timer);
            } else if (input instanceof Input.Ready) {
                ready(at);
            } else if (input instanceof Input.Changed changed) {
                other.core.changed(other.core.rules(), changed.atNanos());
            } else if (others > 0 && Plans.numberOf(input) == earlier.number()) {
                inStep = Plans.follow(input, earlier, recorded.rules(), other, others);
            } else if (input instanceof Input.Sent late && late.number() == doubted && doubted != earlier.number()) {
                other.core.sent(othersDoubted, late.inOrder(), late.atNanos());
            }
        }

        // What comes

        private void observe(Occurrence occurrence) {
            if (occurrence instanceof Occurrence.Violated
                    || recorded.tally().refused() > earlier.tally().refused()) {
                return;
            }
            boolean lost = recorded.tally().dropped() > earlier.tally().dropped();
            Occurrence here = occurrence;
            if (occurrence.visit() != Occurrence.ANY_VISIT) {
                boolean same = occurrence.visit() == earlier.visit()
                        && earlier.at().evolved().equals(other.at().evolved());
                here = same ? Reframed.inVisit(occurrence, other.core.visit()) : null;
            }
            if (here != null && !(lost && here.source().isButton() && !here.isFact())) {
                came(other.observe(here, lost), lost);
            }
        }

        /** A timer of the converter fires: the same one of the other models does, too. */
        private void fires(Input.TimerDue timer) {
            Long due = timer.visit() == earlier.visit() ? earlier.due(timer.event()) : null;
            if (due == null || recorded.tally().observed() == earlier.tally().observed()) {
                return;
            }
            converter.timers().remove(timer.event());
            boolean lost = recorded.tally().dropped() > earlier.tally().dropped();
            for (Map.Entry<Event, Long> each : other.timers().entrySet()) {
                if (each.getKey().toString().equals(timer.event().toString())
                        && each.getValue().equals(due)) {
                    came(other.fires(each.getKey(), lost, timer.atNanos()), lost);
                    return;
                }
            }
        }

        /** @param others the number that the other models have for what the converter has just counted; 0 for none */
        private void came(long others, boolean lost) {
            long before = earlier.tally().observed();
            if (others > 0 && !lost && recorded.tally().observed() > before) {
                pairs.add(before + 1, others);
            } else {
                early.remove(others);
            }
        }

        /** Fires the timers due by then, earliest first, but for those that fire when the converter's do. */
        void fire(long at) {
            for (Event next = nextTimer(at); next != null; next = nextTimer(at)) {
                long due = Math.max(other.timers().getOrDefault(next, at), other.core.nowNanos());
                early.remove(other.fires(next, false, due));
                settle(due);
            }
        }

        private @Nullable Event nextTimer(long at) {
            Map.Entry<Event, Long> next = null;
            for (Map.Entry<Event, Long> timer : other.timers().entrySet()) {
                boolean own = !timer.getValue().equals(earlier.due(timer.getKey()));
                boolean sooner = next == null || timer.getValue() < next.getValue();
                next = own && sooner && timer.getValue() <= at ? timer : next;
            }
            return next == null ? null : next.getKey();
        }

        // Turns

        /** The converter has begun an occurrence: the other models begin theirs, after what comes before it there. */
        private void ready(long at) {
            Pending begun = converter.began() ? converter.begun() : null;
            if (begun == null || other.isUnderWay()) {
                if (!recorded.isBusy()) {
                    runAll(at);
                }
                return;
            }
            Long others = pairs.others(begun.number());
            boolean comes = others == null || other.isOpen(others);
            for (Pending next = upcoming(); comes && next != null; next = upcoming()) {
                boolean same = others == null ? isAlike(next, begun) : next.number() == others;
                comes = same || others != null;
                Pending present = comes ? other.begin() : null;
                if (present == null) {
                    return;
                }
                if (same) {
                    pairs.add(begun.number(), present.number());
                    inStep = true;
                    return;
                }
                other.run(at);
            }
        }

        /** What may begin in the other models; null if nothing may. */
        private @Nullable Pending upcoming() {
            return other.core.isOpen() && !other.isUnderWay() ? other.core.upcoming() : null;
        }

        private boolean isAlike(Pending others, Pending pending) {
            return pairs.others(pending.number()) == null
                    && pairs.converters(others.number()) == null
                    && pending.occurrence().source() == others.occurrence().source()
                    && pending.occurrence().getClass() == others.occurrence().getClass()
                    && !(pending.occurrence() instanceof Occurrence.Heard);
        }

        private void runAll(long at) {
            while (other.core.isOpen() && !other.isUnderWay() && other.begin() != null) {
                other.run(at);
            }
        }

        /** What only the other models have gets its turn, unless something waits before it that the converter has, too. */
        private void settle(long at) {
            for (Pending next = upcoming(); next != null && !waits(next); next = upcoming()) {
                if (other.begin() == null) {
                    return;
                }
                other.run(at);
            }
        }

        /** Whether this has its turn when the converter's has. */
        private boolean waits(Pending next) {
            Long number = next.number() == 0 ? null : pairs.converters(next.number());
            if (number != null) {
                return !then.containsKey(number);
            }
            Pending recordeds = recorded.upcoming();
            return recordeds != null && isAlike(next, recordeds);
        }

        // Ends

        private void isOver(Over each, Input input, long at) {
            long number = each.number() == 0 && input instanceof Input.Observed
                    ? recorded.tally().observed()
                    : each.number();
            Ending ending = each.ending();
            if (ending != null && ending.ended().occurrence() instanceof Occurrence.Evolved) {
                ending = ending.ifMoved();
            }
            if (number == 0) {
                return;
            }
            Long others = pairs.others(number);
            if (others == null && ending != null && ending.ended().occurrence() instanceof Occurrence.Found found) {
                // No monitor has reported it: the device was asked, or obeyed late.
                others = other.find(found);
                pairs.add(number, others);
            }
            if (others == null || others == 0) {
                part(number);
                compare(ending, null);
                return;
            }
            then.put(number, Optional.ofNullable(ending));
            finish(others, at);
            Optional<Ending> answer = early.remove(others);
            if (answer != null || (then.containsKey(number) && !other.isOpen(others))) {
                then.remove(number);
                part(number);
                compare(ending, answer == null ? null : answer.orElse(null));
            }
        }

        /** The converter has ended it: the other models end it as far as they can. */
        private void finish(long others, long at) {
            boolean continues = !early.containsKey(others);
            while (continues && other.isOpen(others)) {
                Pending next = upcoming();
                if (other.isUnderWay()) {
                    other.run(at);
                    continues = !other.isUnderWay();
                } else {
                    continues = next != null && (next.number() == others || !waits(next)) && other.begin() != null;
                }
            }
        }

        private void forgetWhatIsGone() {
            Set<Long> open = Pairs.open(recorded);
            Set<Long> gone = pairs.all();
            gone.removeAll(open);
            gone.removeAll(then.keySet());
            gone.forEach(Comparison.this::part);
        }
    }
}
