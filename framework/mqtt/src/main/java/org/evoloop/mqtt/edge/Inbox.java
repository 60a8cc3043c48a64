package org.evoloop.mqtt.edge;

import java.util.ArrayDeque;
import java.util.Deque;
import org.evoloop.mqtt.Message;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The messages that wait for the device, in order: the newest state, since a state replaces all before it, and the newest
 * {@value #MOST_COMMANDS} commands. The fleet waits for the answer to the newest command only; for those that are
 * dropped unanswered, it has given up waiting or will query the device's state.
 *
 * <p>Threading: thread-safe; {@link #put} never waits.
 */
final class Inbox {
    static final int MOST_COMMANDS = 16;

    private static final Logger LOG = LoggerFactory.getLogger(EdgeDevice.class);

    private final String commandTopic;
    private final Deque<Message> waiting = new ArrayDeque<>();
    private int commands;

    /** @param commandTopic the topic of commands; messages on any other are states */
    Inbox(String commandTopic) {
        this.commandTopic = commandTopic;
    }

    private boolean isCommand(Message message) {
        return message.topic().equals(commandTopic);
    }

    synchronized void put(Message message) {
        if (!isCommand(message)) {
            waiting.removeIf(each -> !isCommand(each));
        } else if (commands == MOST_COMMANDS) {
            waiting.removeFirstOccurrence(oldestCommand());
            LOG.warn("more than {} commands wait on {}; the oldest is dropped", MOST_COMMANDS, commandTopic);
        } else {
            commands++;
        }
        waiting.add(message);
        notifyAll();
    }

    private Message oldestCommand() {
        return waiting.stream().filter(this::isCommand).findFirst().orElseThrow();
    }

    /** Waits for the next message. */
    synchronized Message take() throws InterruptedException {
        while (waiting.isEmpty()) {
            wait();
        }
        Message next = waiting.removeFirst();
        if (isCommand(next)) {
            commands--;
        }
        return next;
    }
}
