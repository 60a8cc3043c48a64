package org.evoloop.mqtt;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Predicate;
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

    private record Wait(Predicate<String> wanted, Runnable then, CompletableFuture<String> state) {}

    Reports(MqttDevice device) {
        this.device = device;
        // Before a monitor, so that a step is over before its result is found.
        this.rules = new TopicRules(device.clock(), device.connection()::subscribeFirst);
        device.onLost(why -> fail(current, why));
    }

    /** Hears of the device's state. */
    void subscribe(String topic, Meanings states) {
        rules.add(topic, states, TopicRules.Use.NEWS, state -> hear(state.name()));
    }

    private void hear(String state) {
        Wait wait = current;
        if (wait != null && !wait.state().isDone() && wait.wanted().test(state)) {
            wait.then().run();
            wait.state().complete(state);
        }
    }

    private static void fail(@Nullable Wait wait, String why) {
        if (wait != null) {
            wait.state().completeExceptionally(new IllegalStateException(why));
        }
    }

    /**
     * Publishes a message and waits for the report of a state.
     *
     * @param then run when it is reported, before anybody else hears of it
     * @throws UnknownEffectException if there is none within the limit, or the device is lost meanwhile
     */
    String await(Message message, Predicate<String> wanted, Duration limit, Runnable then)
            throws UnknownEffectException, InterruptedException {
        Wait wait = new Wait(wanted, then, new CompletableFuture<>());
        String late = "the device has not reported within " + limit.toMillis() + " ms what became of the message to "
                + message.topic();
        Clock.Timer timer = device.clock().schedule(limit, () -> fail(wait, late));
        current = wait;
        try {
            device.connection().publish(message);
            return wait.state().get();
        } catch (ExecutionException none) {
            Throwable cause = none.getCause();
            throw new UnknownEffectException(cause == null ? late : String.valueOf(cause.getMessage()), none);
        } finally {
            current = null;
            timer.cancel();
        }
    }
}
