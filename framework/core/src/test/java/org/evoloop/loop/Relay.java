package org.evoloop.loop;

import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/** A loop with threads that passes strings on, and whose components can be made to throw and to hang. */
final class Relay implements AutoCloseable {
    static final int PATIENCE_SECONDS = 20;

    final BlockingQueue<String> input = new LinkedBlockingQueue<>();
    final BlockingQueue<String> output = new LinkedBlockingQueue<>();
    final BlockingQueue<Failure<String>> failures = new LinkedBlockingQueue<>();
    final BlockingQueue<String> dropped = new LinkedBlockingQueue<>();
    final MapeLoop<String, String, String> loop;
    volatile boolean listenerFails;

    Relay(LoopConfig config) {
        this(config, Dispatch.toEach());
    }

    Relay(LoopConfig config, Dispatch<String> dispatch) {
        this(config, dispatch, new PlainQueue<>(config.queueCapacity()));
    }

    Relay(LoopConfig config, Dispatch<String> dispatch, Intake<String> intake) {
        loop = new MapeLoop<>(config, listener(), dispatch, intake);
        loop.addMonitor(new Ears("ears"));
        loop.addAnalyze(new Brain());
        loop.addPlan(new Will());
        loop.addExecute(new Hand("hand"));
    }

    final LoopListener<String> listener() {
        return new LoopListener<>() {
            @Override
            public void failed(Failure<String> failure) {
                failures.add(failure);
                if (listenerFails) {
                    throw new IllegalStateException("cannot listen");
                }
            }

            @Override
            public void dropped(String occurrence, boolean first) {
                dropped.add(occurrence + (first ? " first" : ""));
            }
        };
    }

    static Relay running(ThreadingModel threading) {
        return running(threading, Duration.ofSeconds(2));
    }

    static Relay running(ThreadingModel threading, Duration joinLimit) {
        Relay relay = new Relay(LoopConfig.defaults("relay", new ManualClock())
                .withThreading(threading)
                .withJoinLimit(joinLimit));
        relay.loop.build();
        relay.loop.start();
        return relay;
    }

    final class Ears extends Monitor<String> {
        Ears(String name) {
            super(name);
        }

        @Override
        protected @Nullable String getEvent() throws Exception {
            String heard = input.take();
            if (heard.equals("deaf")) {
                throw new IllegalStateException("cannot hear");
            }
            return heard.equals("nothing") ? null : heard;
        }
    }

    static final class Brain extends Analyze<String, String> {
        @Override
        protected @Nullable String analyze(String occurrence) {
            if (occurrence.equals("confusing")) {
                throw new IllegalStateException("cannot think");
            }
            return occurrence.equals("meaningless") ? null : occurrence;
        }
    }

    static final class Will extends Plan<String, String> {
        @Override
        protected @Nullable String plan(String analysis) {
            return analysis.equals("unwanted") ? null : analysis;
        }
    }

    /** Outputs its input; "hang" waits to be interrupted, "deadlock" for {@link #release} only. */
    final class Hand extends Execute<String> {
        final CountDownLatch hanging = new CountDownLatch(1);
        final CountDownLatch release = new CountDownLatch(1);

        Hand(String name) {
            super(name);
        }

        @Override
        protected void execute(String plan) throws Exception {
            switch (plan) {
                case "clumsy" -> throw new IllegalStateException("cannot grip");
                case "hang" -> {
                    hanging.countDown();
                    release.await();
                }
                case "deadlock" -> {
                    hanging.countDown();
                    awaitUninterruptibly(release);
                    output.add(name() + ":too late");
                }
                default -> output.add(name() + ":" + plan);
            }
        }
    }

    static void awaitUninterruptibly(CountDownLatch latch) {
        boolean released = false;
        while (!released) {
            try {
                latch.await();
                released = true;
            } catch (InterruptedException deaf) {
                // This is what a stuck component does.
                released = false;
            }
        }
    }

    static <T> T take(BlockingQueue<T> queue) throws InterruptedException {
        T taken = queue.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
        if (taken == null) {
            throw new AssertionError("nothing came");
        }
        return taken;
    }

    static void await(CountDownLatch latch) throws InterruptedException {
        if (!latch.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError("never happened");
        }
    }

    ComponentStatus status(String name) {
        return loop.components().stream()
                .filter(component -> component.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Override
    public void close() {
        loop.close();
    }
}
