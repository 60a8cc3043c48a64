package org.evoloop.payload.report;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.payload.Meanings;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Waits for what a device reports after something was sent to it.
 *
 * <p>Threading: thread-safe; {@link #await} for one thread at a time.
 */
final class Confirmations {
    private final ReportingDevice device;
    private final ReportRules rules;
    private volatile @Nullable Wait current;

    /** What is waited for. */
    private static final class Wait implements Pending {
        private final String wanted;
        private final Runnable then;
        private final CompletableFuture<String> state = new CompletableFuture<>();
        private boolean takesAny;
        private @Nullable String newest;

        private Wait(String wanted, Runnable then) {
            this.wanted = wanted;
            this.then = then;
        }

        private synchronized void hear(String reported) {
            newest = reported;
            if (!state.isDone() && (takesAny || wanted.equals(reported))) {
                then.run();
                state.complete(reported);
            }
        }

        /** From now on any state will do, also the newest so far. */
        private synchronized void takeAny() {
            takesAny = true;
            if (newest != null) {
                hear(newest);
            }
        }

        @Override
        public synchronized void fail(String why) {
            state.completeExceptionally(new IllegalStateException(why));
        }

        @Override
        public synchronized void refuse(String why) {
            state.completeExceptionally(new Refused(why));
        }

        private synchronized boolean isAboutToTakeOne() {
            return !takesAny && newest != null;
        }
    }

    /**
     * Something that is sent.
     *
     * @param what for messages
     */
    record Sent(String what, Transmission sending) {}

    /** The device has not taken what was sent, so it has no effect. */
    static final class Refused extends IllegalStateException {
        private static final long serialVersionUID = 1L;

        Refused(String why) {
            super(why);
        }
    }

    Confirmations(ReportingDevice device) {
        this.device = device;
        // Before a monitor, so that a step is over before its result is found.
        this.rules = new ReportRules(device.clock(), device.turns(), device::subscribeFirst);
        device.onLost(why -> fail(current, why));
    }

    /** Hears of the device's state. */
    void subscribe(String source, Meanings states) {
        rules.add(source, states, ReportRules.Use.NEWS, state -> hear(state.name()));
    }

    private void hear(String state) {
        Wait wait = current;
        if (wait != null) {
            wait.hear(state);
        }
    }

    private static void fail(@Nullable Wait wait, String why) {
        if (wait != null) {
            wait.fail(why);
        }
    }

    /**
     * Sends something and waits for the report of a state.
     *
     * @param then run when it is reported, before anybody else hears of it
     * @throws UnknownEffectException if there is none within the limit, or the device is lost meanwhile
     * @throws Exception as {@link Transmission}
     */
    void await(Sent sent, String wanted, Duration limit, Runnable then) throws Exception {
        Wait wait = new Wait(wanted, then);
        await(sent, wait, limit, wait::fail);
    }

    /**
     * Sends a question and waits for the answer.
     *
     * @param wanted the state that counts whenever it is reported
     * @param from when others count, too; then the newest does, if one has been reported
     * @param then run when it is answered, before anybody else hears of it
     * @throws UnknownEffectException if there is none within the limit, or the device is lost meanwhile
     * @throws Exception as {@link Transmission}
     */
    String ask(Sent question, String wanted, Duration from, Duration limit, Runnable then) throws Exception {
        Wait wait = new Wait(wanted, then);
        Clock.Timer later = device.clock().schedule(from, () -> device.turns().take(wait::takeAny));
        try {
            return await(question, wait, limit, late -> {
                if (!wait.isAboutToTakeOne()) {
                    wait.fail(late);
                }
            });
        } finally {
            later.cancel();
        }
    }

    private String await(Sent sent, Wait wait, Duration limit, Consumer<String> onLimit) throws Exception {
        String late = "the device has not reported within " + limit.toMillis() + " ms what became of " + sent.what();
        Clock.Timer timer = device.clock().schedule(limit, () -> onLimit.accept(late));
        current = wait;
        try {
            sent.sending().send(wait);
            return wait.state.get();
        } catch (ExecutionException none) {
            Throwable cause = none.getCause();
            if (cause instanceof Refused refused) {
                throw refused;
            }
            throw new UnknownEffectException(cause == null ? late : String.valueOf(cause.getMessage()), none);
        } finally {
            current = null;
            timer.cancel();
        }
    }
}
