package org.evoloop.loop;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/** A sequencer with one component, which ends each cycle. Nothing starts its threads; the test's actors play them. */
final class Rig implements LoopListener<Object> {
    private static final int SPINS = 20;

    /** Far longer than anything here takes, to tell what never happens from what is late. */
    private static final long PATIENCE_NANOS = 5_000_000_000L;

    private static final long LITTLE_PATIENCE_NANOS = 20_000_000;

    /** Becomes short once something has failed to happen, so that later failures take less time. */
    private static volatile long patienceNanos = PATIENCE_NANOS;

    final LoopLock lock = new LoopLock();
    final Crew crew;
    final Pipeline<Object, Object, Object> pipeline = new Pipeline<>("rig", Dispatch.toEach());
    final Sequencer<Object> sequencer;
    final Gate<Object> gate;
    final Counting intake;
    final StageWorker<Object> stage;
    final AtomicInteger runs = new AtomicInteger();
    final AtomicInteger givenUp = new AtomicInteger();

    Rig(ThreadingModel threading, int queueCapacity) {
        LoopConfig config = config(threading, queueCapacity);
        crew = new Crew(config);
        intake = new Counting(queueCapacity);
        sequencer = new Sequencer<>(config, this, intake, pipeline, lock);
        gate = new Gate<>(config, sequencer, lock);
        stage = new StageWorker<>(new Nothing(), crew, sequencer, (by, input) -> {
            runs.incrementAndGet();
            takeAWhile();
            return by.handOn(null, null);
        });
        gate.become(LoopState.RUNNING);
    }

    /** Leaves about enough time for the other actors to interfere. */
    private static void takeAWhile() {
        for (int i = 0; i < SPINS; i++) {
            Thread.onSpinWait();
        }
    }

    static LoopConfig config(ThreadingModel threading, int queueCapacity) {
        return LoopConfig.defaults("rig", new ManualClock())
                .withThreading(threading)
                .withQueueCapacity(queueCapacity);
    }

    /** From now on, what is offered is run. */
    Rig ready() {
        pipeline.lead(stage, null, List.of());
        return this;
    }

    /** Gives the component up as the watchdog for late components does; does nothing if none is at work. */
    void giveUp() {
        giveUp(stage);
    }

    /** Gives {@code late} up if it is at work. */
    void giveUp(StageWorker<?> late) {
        Failure<Object> failure = null;
        lock.acquire();
        try {
            if (sequencer.busy() == late) {
                failure = sequencer.giveUp(late, "was late");
            }
        } finally {
            lock.release();
        }
        sequencer.proceedAfter(late, failure);
    }

    /** The current carrier thread. */
    CarrierThread carrier() {
        return Objects.requireNonNull(crew.shared(), "a loop without a carrier");
    }

    /** Waits for a condition, but not forever; returns whether it became true. */
    static boolean await(BooleanSupplier event) {
        long begun = System.nanoTime();
        while (!event.getAsBoolean()) {
            if (System.nanoTime() - begun > patienceNanos) {
                patienceNanos = LITTLE_PATIENCE_NANOS;
                return false;
            }
            LoopThread.giveWay();
        }
        return true;
    }

    @Override
    public void failed(Failure<Object> failure) {
        throw new AssertionError(failure.toString(), failure.cause());
    }

    @Override
    public void givenUp(Failure<Object> failure) {
        givenUp.incrementAndGet();
    }

    @Override
    public void dropped(Object occurrence, boolean first) {}

    /** A component without behavior of its own; its worker defines what it does. */
    static final class Nothing extends Analyze<Object, Object> {
        @Override
        protected Object analyze(Object occurrence) {
            return occurrence;
        }
    }

    /** A queue that counts the completed cycles. */
    static final class Counting implements Intake<Object> {
        private final PlainQueue<Object> backlog;
        final AtomicInteger ends = new AtomicInteger();

        Counting(int capacity) {
            backlog = new PlainQueue<>(capacity);
        }

        @Override
        public Admission offer(Object occurrence) {
            return backlog.offer(occurrence);
        }

        @Override
        public boolean hasRoom(Object occurrence) {
            return backlog.hasRoom(occurrence);
        }

        @Override
        public @Nullable Object next() {
            return backlog.next();
        }

        @Override
        public void ended() {
            ends.incrementAndGet();
            backlog.ended();
        }

        @Override
        public void opened() {
            backlog.opened();
        }

        @Override
        public void closed() {
            backlog.closed();
        }

        @Override
        public QueueStatus status() {
            return backlog.status();
        }
    }
}
