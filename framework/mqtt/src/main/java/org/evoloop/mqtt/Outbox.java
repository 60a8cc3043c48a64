package org.evoloop.mqtt;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What is to be published. Of states it keeps the newest of each topic, for as long as it lives, {@value #MOST_TOPICS}
 * topics at most; of other messages the last {@value #MOST_WAITING}.
 *
 * <p>Threading: thread-safe; {@link #put} never waits.
 */
final class Outbox {
    static final int MOST_TOPICS = 512;
    static final int MOST_WAITING = 256;

    private static final Logger LOG = LoggerFactory.getLogger(BrokerConnection.class);

    private final Map<String, Message> states = new HashMap<>();
    /** The topics whose state is not at the broker yet, the longest waiting first. */
    private final Set<String> due = new LinkedHashSet<>();

    private final Deque<Message> others = new ArrayDeque<>();
    private long lost;
    private boolean losing;

    /** Puts a message in; a state that is known already changes nothing. */
    synchronized void put(Message message) {
        if (message.kind() == Message.Kind.STATE) {
            if (!states.containsKey(message.topic()) && states.size() >= MOST_TOPICS) {
                lose("there are states of more than " + MOST_TOPICS + " topics");
                return;
            }
            if (!message.equals(states.put(message.topic(), message))) {
                due.add(message.topic());
            }
        } else {
            if (others.size() >= MOST_WAITING) {
                others.removeFirst();
                lose("more than " + MOST_WAITING + " messages wait for the broker");
            }
            others.addLast(message);
        }
        notifyAll();
    }

    private void lose(String why) {
        lost++;
        if (!losing) {
            losing = true;
            LOG.warn("{}; some are lost", why);
        }
    }

    /**
     * Waits for the next message.
     *
     * @param live whether it is worth waiting; {@link #wake} has it asked again
     * @return null if it is not
     */
    synchronized @Nullable Message take(BooleanSupplier live) throws InterruptedException {
        while (live.getAsBoolean()) {
            Message next = poll();
            if (next != null) {
                return next;
            }
            wait();
        }
        return null;
    }

    private @Nullable Message poll() {
        Iterator<String> first = due.iterator();
        if (first.hasNext()) {
            String topic = first.next();
            first.remove();
            return states.get(topic);
        }
        losing = false;
        return others.pollFirst();
    }

    /** This message, taken last, did not reach the broker. */
    synchronized void giveBack(Message message) {
        if (message.kind() == Message.Kind.STATE) {
            due.add(message.topic());
        } else if (message.kind() == Message.Kind.EVENT && others.size() < MOST_WAITING) {
            others.addFirst(message);
        }
    }

    /** Every state is to be published again. */
    synchronized void republish() {
        due.addAll(states.keySet());
        notifyAll();
    }

    /** Nobody is there to obey a command. */
    synchronized void discardCommands() {
        others.removeIf(message -> message.kind() == Message.Kind.COMMAND);
    }

    /** Has whoever takes ask whether it is worth waiting. */
    synchronized void wake() {
        notifyAll();
    }

    /** Whether everything has been taken. */
    synchronized boolean isEmpty() {
        return due.isEmpty() && others.isEmpty();
    }

    /** How many messages were lost. */
    synchronized long lost() {
        return lost;
    }
}
