package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.loop.Relay.await;
import static org.evoloop.loop.Relay.take;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Whether there is room depends on the occurrence: a state may defer some, which then have places of their own. */
@InEachThreading
@Timeout(60)
class RoomTest {
    private final Relay relay;

    /** A queue that never has room for what is "deferred", and for anything else only while it is empty. */
    private static final class Choosy implements Intake<String> {
        private final PlainQueue<String> backlog = new PlainQueue<>(8);

        @Override
        public Admission offer(String occurrence) {
            return backlog.offer(occurrence);
        }

        @Override
        public boolean hasRoom(String occurrence) {
            return !occurrence.equals("deferred") && backlog.status().depth() == 0;
        }

        @Override
        public @Nullable String next() {
            return backlog.next();
        }

        @Override
        public void ended() {
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

    RoomTest(ThreadingModel threading) {
        relay = new Relay(
                LoopConfig.defaults("room", new ManualClock()).withThreading(threading),
                Dispatch.toEach(),
                new Choosy());
        relay.loop.build();
        relay.loop.start();
    }

    @Test
    void whoeverHasRoomIsWokenAlthoughOthersHaveNone() throws InterruptedException {
        Relay.Hand hand = relay.new Hand("busy");
        List<Thread> waiting = new ArrayList<>();
        try (relay) {
            relay.loop.exchange("hand", hand);
            relay.loop.offer("hang");
            await(hand.hanging);
            relay.loop.offer("next");
            for (String occurrence : List.of("deferred", "deferred", "welcome")) {
                Thread putting = new Thread(() -> put(occurrence));
                putting.start();
                waiting.add(putting);
                while (putting.getState() != Thread.State.WAITING) {
                    Thread.onSpinWait();
                }
            }
            hand.release.countDown();

            assertThat(take(relay.output)).isEqualTo("busy:next");
            assertThat(take(relay.output)).isEqualTo("busy:welcome");
        }
        for (Thread putting : waiting) {
            putting.join();
        }
    }

    private void put(String occurrence) {
        try {
            relay.loop.put(occurrence);
        } catch (InterruptedException stop) {
            throw new AssertionError(stop);
        }
    }
}
