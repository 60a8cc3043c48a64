package org.evoloop.loop;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.time.Clock;

/**
 * The options of a loop.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class LoopConfig {
    private final String name;
    private final Clock clock;
    private final int queueCapacity;
    private final Duration pressAge;
    private final Duration stepLimit;
    private final Duration joinLimit;
    private final WaitStrategy waiting;
    private final ThreadingModel threading;

    private LoopConfig(
            String name,
            Clock clock,
            int queueCapacity,
            Duration pressAge,
            Duration stepLimit,
            Duration joinLimit,
            WaitStrategy waiting,
            ThreadingModel threading) {
        requireNonNull(name, "the name of a loop is null");
        requireNonNull(clock, "the clock of a loop is null");
        requireNonNull(pressAge, "pressAge is null");
        requireNonNull(stepLimit, "stepLimit is null");
        requireNonNull(joinLimit, "joinLimit is null");
        requireNonNull(waiting, "waiting is null");
        requireNonNull(threading, "threading is null");
        this.name = name;
        this.clock = clock;
        this.queueCapacity = queueCapacity;
        this.pressAge = pressAge;
        this.stepLimit = stepLimit;
        this.joinLimit = joinLimit;
        this.waiting = waiting;
        this.threading = threading;
    }

    /**
     * The defaults: room for 8 waiting occurrences, presses that wait for at most 10 s, a step limit of 30 s, a join limit
     * of 2 s, one carrier for all components.
     */
    public static LoopConfig defaults(String name, Clock clock) {
        return new LoopConfig(
                name,
                clock,
                8,
                Duration.ofSeconds(10),
                Duration.ofSeconds(30),
                Duration.ofSeconds(2),
                WaitStrategy.YIELD_THEN_PARK,
                ThreadingModel.SINGLE_CARRIER);
    }

    /** A copy with room for {@code capacity} waiting occurrences, see {@link #queueCapacity}. */
    public LoopConfig withQueueCapacity(int capacity) {
        return new LoopConfig(name, clock, capacity, pressAge, stepLimit, joinLimit, waiting, threading);
    }

    /** A copy in which a press may wait for at most {@code limit}, see {@link #pressAge}. */
    public LoopConfig withPressAge(Duration limit) {
        return new LoopConfig(name, clock, queueCapacity, limit, stepLimit, joinLimit, waiting, threading);
    }

    /** A copy with another limit for one step, in the clock's time. */
    public LoopConfig withStepLimit(Duration limit) {
        return new LoopConfig(name, clock, queueCapacity, pressAge, limit, joinLimit, waiting, threading);
    }

    /** A copy with another limit for threads that were interrupted, in real time. */
    public LoopConfig withJoinLimit(Duration limit) {
        return new LoopConfig(name, clock, queueCapacity, pressAge, stepLimit, limit, waiting, threading);
    }

    /** A copy with another wait strategy. */
    public LoopConfig withWaiting(WaitStrategy strategy) {
        return new LoopConfig(name, clock, queueCapacity, pressAge, stepLimit, joinLimit, strategy, threading);
    }

    /** A copy with another threading model. */
    public LoopConfig withThreading(ThreadingModel model) {
        return new LoopConfig(name, clock, queueCapacity, pressAge, stepLimit, joinLimit, waiting, model);
    }

    /** A copy without threads: the caller of {@link MapeLoop#observe} and {@link MapeLoop#step} drives it. */
    public LoopConfig withoutThreads() {
        return withThreading(ThreadingModel.CALLER);
    }

    /** Whether the loop has threads. */
    public boolean threads() {
        return threading != ThreadingModel.CALLER;
    }

    /** Every option that is out of range, with its value and what is allowed. */
    public List<String> problems() {
        List<String> found = new ArrayList<>();
        if (queueCapacity < 0 || queueCapacity > 1_000_000) {
            found.add("queueCapacity is " + queueCapacity + ", allowed is 0 to 1000000");
        }
        if (isNoLimit(pressAge)) {
            found.add("pressAge is " + pressAge + ", allowed is 1 ms to " + Clock.LONGEST.toDays() + " days");
        }
        if (isNoLimit(stepLimit)) {
            found.add("stepLimit is " + stepLimit + ", allowed is 1 ms to " + Clock.LONGEST.toDays() + " days");
        }
        if (joinLimit.compareTo(Duration.ofMillis(1)) < 0 || joinLimit.compareTo(Duration.ofMinutes(1)) > 0) {
            found.add("joinLimit is " + joinLimit + ", allowed is 1 ms to 1 min");
        }
        if (outOfRange(waiting.looks()) || outOfRange(waiting.yields())) {
            found.add("waiting is '" + waiting + "', allowed are 0 to 10000 looks and yields");
        }
        return found;
    }

    private static boolean isNoLimit(Duration limit) {
        return limit.compareTo(Duration.ofMillis(1)) < 0 || limit.compareTo(Clock.LONGEST) > 0;
    }

    private static boolean outOfRange(int rounds) {
        return rounds < 0 || rounds > 10_000;
    }

    /** Part of every thread's name. */
    public String name() {
        return name;
    }

    /** The clock for back-off and limits. */
    public Clock clock() {
        return clock;
    }

    /**
     * How many occurrences that may be lost may wait behind the one in the loop, 0 to 1,000,000; with 0, one that comes
     * while the loop is busy is lost. A converter loses only controllers' events; others do not take up this room.
     */
    public int queueCapacity() {
        return queueCapacity;
    }

    /**
     * How long a control that was operated counts, 1 ms to {@link Clock#LONGEST}, in the clock's time. A press that is
     * older when its turn comes is stale: whoever pressed no longer expects anything to happen. Time in which no process
     * ran counts, too, if the converter has a journal.
     */
    public Duration pressAge() {
        return pressAge;
    }

    /**
     * How long an analyze, plan or execute component may work on one occurrence before it is interrupted, 1 ms to
     * {@link Clock#LONGEST}, in the clock's time.
     */
    public Duration stepLimit() {
        return stepLimit;
    }

    /** How long to wait for a thread that was interrupted, 1 ms to 1 min, in real time. */
    public Duration joinLimit() {
        return joinLimit;
    }

    /** How a thread waits for its turn. */
    public WaitStrategy waiting() {
        return waiting;
    }

    /**
     * Which threads call the components: by default {@link ThreadingModel#SINGLE_CARRIER}, which is the fastest on few
     * processors.
     */
    public ThreadingModel threading() {
        return threading;
    }
}
