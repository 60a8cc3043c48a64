package org.evoloop.benchmarks.ring;

import java.util.Locale;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedTransferQueue;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/** A way for one thread to hand an object to the next. */
public interface HandOff {
    void give(Object token) throws InterruptedException;

    Object take() throws InterruptedException;

    /** The hand-offs of the JDK, and the slot of the loop, without the loop. */
    enum Kind {
        SYNCHRONOUS_QUEUE {
            @Override
            public HandOff make() {
                return queue(new SynchronousQueue<>());
            }
        },
        LINKED_TRANSFER_QUEUE {
            @Override
            public HandOff make() {
                return queue(new LinkedTransferQueue<>());
            }
        },
        ARRAY_BLOCKING_QUEUE {
            @Override
            public HandOff make() {
                return queue(new ArrayBlockingQueue<>(1));
            }
        },
        YIELDING_SLOT {
            @Override
            public HandOff make() {
                return new Slot(30);
            }
        },
        PARKING_SLOT {
            @Override
            public HandOff make() {
                return new Slot(0);
            }
        };

        /** Creates a hand-off. */
        public abstract HandOff make();

        /** The name in the table: {@code LinkedTransferQueue}. */
        String label() {
            StringBuilder label = new StringBuilder();
            for (String word : name().split("_", -1)) {
                label.append(word.charAt(0)).append(word.substring(1).toLowerCase(Locale.ROOT));
            }
            return label.toString();
        }

        private static HandOff queue(BlockingQueue<Object> queue) {
            return new HandOff() {
                @Override
                public void give(Object token) throws InterruptedException {
                    queue.put(token);
                }

                @Override
                public Object take() throws InterruptedException {
                    return queue.take();
                }
            };
        }
    }

    /** A slot for one object. A waiting thread yields a few times before it parks. */
    final class Slot implements HandOff {
        private final int yields;
        private volatile @Nullable Object token;
        private volatile @Nullable Thread asleep;

        Slot(int yields) {
            this.yields = yields;
        }

        @Override
        public void give(Object given) {
            token = given;
            Thread waiter = asleep;
            if (waiter != null) {
                LockSupport.unpark(waiter);
            }
        }

        @Override
        @SuppressWarnings("ThreadPriorityCheck") // yielding is what is compared
        public Object take() throws InterruptedException {
            for (int round = 0; token == null; round++) {
                if (round < yields) {
                    Thread.yield();
                } else {
                    asleep = Thread.currentThread();
                    if (token == null) {
                        LockSupport.park(this);
                    }
                    asleep = null;
                    if (Thread.interrupted()) {
                        throw new InterruptedException();
                    }
                }
            }
            Object taken = token;
            token = null;
            return taken == null ? this : taken;
        }
    }
}
