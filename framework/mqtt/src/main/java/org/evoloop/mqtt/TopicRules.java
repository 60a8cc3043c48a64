package org.evoloop.mqtt;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Steady;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * What the messages on some topics mean: the first rule of a topic that applies to a message is used.
 *
 * <p>Threading: rules are added by one thread, before the connection is opened; messages come one at a time.
 */
final class TopicRules {
    private final @Nullable Clock clock;
    private final Turns turns;
    private final BiConsumer<String, Consumer<Message>> subscribe;
    private final Map<String, List<Rule>> rules = new HashMap<>();
    private final List<Held> states = new CopyOnWriteArrayList<>();

    /** Which messages a rule is for. */
    enum Use {
        /** Those that report an event; the broker's retained ones are old. */
        EVENT,
        /** All that report the state. */
        STATE,
        /** Those that report the state as it has become just now. */
        NEWS
    }

    /**
     * No rules so far.
     *
     * @param clock null if no meaning has to hold for a time
     * @param turns those of the messages
     */
    TopicRules(@Nullable Clock clock, Turns turns, BiConsumer<String, Consumer<Message>> subscribe) {
        this.clock = clock;
        this.turns = turns;
        this.subscribe = subscribe;
    }

    /** @throws IllegalArgumentException if a meaning has to hold for a time, and there is no clock */
    void add(String topic, Meanings meanings, Use use, Consumer<Meanings.Meaning> heard) {
        Consumer<Meanings.Meaning> told = use == Use.EVENT ? heard : endingOthers(heard);
        Rule rule = meanings.lasting().isZero()
                ? new Rule(meanings, use, now -> now.ifPresent(told))
                : new Rule(meanings, use, held(topic, meanings, use, told)::hear);
        rules.computeIfAbsent(topic, first -> {
                    List<Rule> ofTopic = new CopyOnWriteArrayList<>();
                    subscribe.accept(topic, message -> hear(ofTopic, message));
                    return ofTopic;
                })
                .add(rule);
    }

    private Held held(String topic, Meanings meanings, Use use, Consumer<Meanings.Meaning> told) {
        Held held = new Held(requireClock(topic), turns, meanings, use, told);
        if (use != Use.EVENT) {
            states.add(held);
        }
        return held;
    }

    /** What one topic says of the state ends what another one has said before, and what has not held for long enough yet. */
    private Consumer<Meanings.Meaning> endingOthers(Consumer<Meanings.Meaning> heard) {
        return state -> {
            states.forEach(held -> held.endUnless(state));
            heard.accept(state);
        };
    }

    private Clock requireClock(String topic) {
        if (clock == null) {
            throw new IllegalArgumentException("what " + topic
                    + " says must hold for a time; give the monitor the device, whose clock measures that");
        }
        return clock;
    }

    private static void hear(List<Rule> ofTopic, Message message) {
        boolean taken = false;
        for (Rule rule : ofTopic) {
            if (rule.use() == Use.STATE || message.kind() != Message.Kind.STATE) {
                // A rule that does not apply ends what it had heard before.
                Optional<Meanings.Meaning> meaning =
                        taken ? Optional.empty() : rule.meanings().of(message.payload());
                taken |= meaning.isPresent();
                rule.then().accept(meaning);
            }
        }
    }

    private record Rule(Meanings meanings, Use use, Consumer<Optional<Meanings.Meaning>> then) {}

    /** Passes on what has held for a time: a state whenever it is reported, an event once, when that has begun. */
    private static final class Held {
        private final Clock clock;
        private final Turns turns;
        private final Steady steady;
        private final Use use;
        private final Consumer<Meanings.Meaning> then;
        private @Nullable String last;
        private Clock.@Nullable Timer timer;

        Held(Clock clock, Turns turns, Meanings meanings, Use use, Consumer<Meanings.Meaning> then) {
            this.clock = clock;
            this.turns = turns;
            this.steady = new Steady(clock, meanings.lasting());
            this.use = use;
            this.then = then;
        }

        void hear(Optional<Meanings.Meaning> now) {
            // Outside of the lock: what is told may wait.
            noted(now).ifPresent(this::settle);
        }

        /** Another topic says that the device is in this state. */
        synchronized void endUnless(Meanings.Meaning state) {
            if (steady.isOther(state)) {
                noted(Optional.empty());
            }
        }

        /** The meaning if it has held for long enough; else a timer looks again. */
        private synchronized Optional<Meanings.Meaning> noted(Optional<Meanings.Meaning> now) {
            steady.see(now);
            if (timer != null) {
                timer.cancel();
            }
            String name = now.map(Meanings.Meaning::name).orElse("");
            if (name.isEmpty() || last == null) {
                // What holds from the beginning has not begun now.
                last = name;
            }
            if (steady.left().isZero()) {
                return now;
            }
            now.ifPresent(meaning -> timer = clock.schedule(steady.left(), () -> turns.take(() -> settle(meaning))));
            return Optional.empty();
        }

        private void settle(Meanings.Meaning meaning) {
            if (isNews(meaning)) {
                then.accept(meaning);
            }
        }

        private synchronized boolean isNews(Meanings.Meaning meaning) {
            boolean news = steady.counts(meaning)
                    && !(use == Use.EVENT && meaning.name().equals(last));
            last = steady.counts(meaning) ? meaning.name() : last;
            return news;
        }
    }
}
