package org.evoloop.mqtt;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.payload.Meanings;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Waits for what a device reports after a message to it.
 *
 * <p>Threading: thread-safe; {@link #await} for one thread at a time.
 */
final class Reports {
    private final MqttDevice device;
    private final TopicRules rules;
    private volatile @Nullable Wait current;

    /** What is waited for. */
    private static final class Wait {
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

        private synchronized void fail(String why) {
            state.completeExceptionally(new IllegalStateException(why));
        }

        private synchronized boolean isAboutToTakeOne() {
            return !takesAny && newest != null;
        }
    }

    Reports(MqttDevice device) {
        this.device = device;
        // Before a monitor, so that a step is over before its result is found.
        this.rules = new TopicRules(device.clock(), device.connection().turns(), device.connection()::subscribeFirst);
        device.onLost(why -> fail(current, why));
    }

    /** Hears of the device's state. */
    void subscribe(String topic, Meanings states) {
        rules.add(topic, states, TopicRules.Use.NEWS, state -> hear(state.name()));
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

    /** Sends something. */
    @FunctionalInterface
    interface Sending {
        /**
         * Sends it.
         *
         * @throws Exception any failure: nothing was sent, unless it is an {@link UnknownEffectException}
         */
        void send() throws Exception;
    }

    /**
     * Sends a command and waits for the report of a state.
     *
     * @param what for messages
     * @param then run when it is reported, before anybody else hears of it
     * @throws UnknownEffectException if there is none within the limit, or the device is lost meanwhile
     * @throws Exception as {@code sending}
     */
    void await(String what, Sending sending, String wanted, Duration limit, Runnable then) throws Exception {
        Wait wait = new Wait(wanted, then);
        await(what, sending, wait, limit, wait::fail);
    }

    /**
     * Publishes a question and waits for the answer.
     *
     * @param wanted the state that counts whenever it is reported
     * @param from when others count, too; then the newest does, if one has been reported
     * @param then run when it is answered, before anybody else hears of it
     * @throws UnknownEffectException if there is none within the limit, or the device is lost meanwhile
     */
    String ask(Message question, String wanted, Duration from, Duration limit, Runnable then) throws Exception {
        Wait wait = new Wait(wanted, then);
        Clock.Timer later =
                device.clock().schedule(from, () -> device.connection().turns().take(wait::takeAny));
        try {
            Sending asking = () -> device.connection().publish(question);
            return await("the message to " + question.topic(), asking, wait, limit, late -> {
                if (!wait.isAboutToTakeOne()) {
                    wait.fail(late);
                }
            });
        } finally {
            later.cancel();
        }
    }

    private String await(String what, Sending sending, Wait wait, Duration limit, Consumer<String> onLimit)
            throws Exception {
        String late = "the device has not reported within " + limit.toMillis() + " ms what became of " + what;
        Clock.Timer timer = device.clock().schedule(limit, () -> onLimit.accept(late));
        current = wait;
        try {
            sending.send();
            return wait.state.get();
        } catch (ExecutionException none) {
            Throwable cause = none.getCause();
            throw new UnknownEffectException(cause == null ? late : String.valueOf(cause.getMessage()), none);
        } finally {
            current = null;
            timer.cancel();
        }
    }
}
