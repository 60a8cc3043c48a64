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
 * The messages to publish. It keeps the newest state of each topic, for at most {@value #MOST_TOPICS} topics,
 * permanently; of other messages it keeps the last {@value #MOST_WAITING}.
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

    /** Adds a message; an unchanged state has no effect. */
    synchronized void put(Message message) {
        if (message.kind() == Message.Kind.STATE) {
            if (!states.containsKey(message.topic()) && states.size() >= MOST_TOPICS) {
                lose("there are states of more than " + MOST_TOPICS + " topics");
                return;
            }
            // A state that changes again before its turn keeps its place: only the newest is published.
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
     * @param live whether to keep waiting; {@link #wake} makes it be evaluated again
     * @return null if not
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

    /**
     * Waits until half of the places for messages are free.
     *
     * @param live whether to keep waiting; {@link #wake} makes it be evaluated again
     */
    synchronized void awaitRoom(BooleanSupplier live) throws InterruptedException {
        while (live.getAsBoolean() && others.size() >= MOST_WAITING / 2) {
            wait();
        }
    }

    private @Nullable Message poll() {
        Iterator<String> first = due.iterator();
        if (first.hasNext()) {
            String topic = first.next();
            first.remove();
            // The newest one, looked up now and not when the topic became due.
            return states.get(topic);
        }
        losing = false;
        Message next = others.pollFirst();
        if (next != null && others.size() < MOST_WAITING / 2) {
            notifyAll();
        }
        return next;
    }

    /** Gives back the last message taken, which did not reach the broker. */
    synchronized void giveBack(Message message) {
        if (message.kind() == Message.Kind.STATE) {
            due.add(message.topic());
        } else if (message.kind() == Message.Kind.EVENT && others.size() < MOST_WAITING) {
            others.addFirst(message);
        }
    }

    /** Marks every state to be published again. */
    synchronized void republish() {
        due.addAll(states.keySet());
        notifyAll();
    }

    /** Discards commands, since no one is there to obey them. */
    synchronized void discardCommands() {
        others.removeIf(message -> message.kind() == Message.Kind.COMMAND);
    }

    /** Makes a waiting {@link #take} check whether to keep waiting. */
    synchronized void wake() {
        notifyAll();
    }

    /** Whether everything has been taken. */
    synchronized boolean isEmpty() {
        return due.isEmpty() && others.isEmpty();
    }

    /** The number of lost messages. */
    synchronized long lost() {
        return lost;
    }
}
