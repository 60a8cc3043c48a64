package org.evoloop.mqtt.edge;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.evoloop.converter.edge.EdgeShell;
import org.evoloop.evolution.Occurrence;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A device of a fleet whose gateway is reached over an MQTT broker: passes on what an {@link EdgeShell} observes, and
 * makes it carry out what the fleet decides.
 *
 * <p>Records are numbered, stored in a file, and published repeatedly until the gateway confirms them; the fleet ignores
 * those that it already has. A record is in the file when {@link #observed} or {@link #answered} returns, and outlives the
 * process from then on; it is on the disk before it is published. A command's number is stored before the command is
 * carried out; none is carried out twice, or after its deadline.
 *
 * <p>Lifecycle: {@link #open}, {@link #close}.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class EdgeDevice implements EdgeShell.Decider, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(EdgeDevice.class);
    private static final String OCCURRENCE = "occurrence";
    private static final String EFFECT = "effect";
    private static final int WINDOW = 100;
    private static final long POLL_MILLIS = 100;
    private static final long PAUSE_MILLIS = 1_000;
    private static final long AGAIN_NANOS = TimeUnit.SECONDS.toNanos(5);
    private static final Duration END_LIMIT = Duration.ofSeconds(5);

    private final String id;
    private final Clock clock;
    private final InstantSource wall;
    private final Consumer<String> linkListener;
    private final BrokerConnection gateway;
    private final Outbox outbox;
    private final LastCommands carried;
    private final Inbox received;
    /** The highest number that the gateway has confirmed. */
    private final AtomicLong confirmed = new AtomicLong();

    private String link = "";
    private volatile boolean closing;
    private @Nullable Thread sender;
    private @Nullable Thread carrier;

    /**
     * Prepares the device; {@link #open} connects it.
     *
     * @param id the device's id in the fleet
     * @param directory for records that the gateway does not have yet; used by this device alone
     * @param clock measures waiting times
     * @param wall the time of day of occurrences
     * @param linkListener receives the state of the link, in words, when it changes
     * @throws java.io.UncheckedIOException if the directory cannot be used
     */
    public EdgeDevice(
            String id,
            BrokerAddress broker,
            Path directory,
            Clock clock,
            InstantSource wall,
            Consumer<String> linkListener) {
        this.id = id;
        this.clock = clock;
        this.wall = wall;
        this.linkListener = linkListener;
        // If the directory was lost, the numbers must be higher than those that the fleet has seen.
        this.outbox = new Outbox(directory, wall.millis());
        this.carried = new LastCommands(directory);
        this.gateway = new BrokerConnection(broker, "edge-" + id);
        this.received = new Inbox(topic("command"));
        gateway.subscribe(topic("command"), received::put);
        gateway.subscribe(topic("state"), received::put);
        gateway.subscribe(topic("kept"), this::confirmed);
    }

    /**
     * Checks that a device's id can be part of its topics.
     *
     * @param what how messages name the id
     * @throws IllegalArgumentException if it cannot
     */
    public static void requireTopicName(String what, String id) {
        if (!id.matches("[^/+#\\s]{1,200}")) {
            throw new IllegalArgumentException(what + " is '" + id
                    + "'; MQTT takes no '/', '+', '#' or spaces in its name, 200 characters at most");
        }
    }

    private String topic(String what) {
        return "evoloop/" + id + '/' + what;
    }

    /** Connects; waits neither for the broker nor for the gateway. */
    public synchronized void open(EdgeShell shell) {
        gateway.open();
        sender = begin("edge-" + id + "-sender", this::sendAll);
        carrier = begin("edge-" + id + "-carrier", () -> carryAll(shell));
    }

    private static Thread begin(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.start();
        return thread;
    }

    // From the device

    @Override
    public void observed(Occurrence occurrence) {
        store(OCCURRENCE, EdgeRecords.occurrence(occurrence, wall.millis()));
    }

    @Override
    public void answered(long sequence, EdgeShell.Result result, String reason, Optional<State> state) {
        store(EFFECT, EdgeRecords.effect(sequence, result, reason, state.orElse(null), wall.millis()));
    }

    /** Does not wait for the disk; the sender forces records to it before it publishes them. */
    private void store(String topic, JsonObject record) {
        try {
            outbox.write(topic, id, record.toString());
        } catch (UncheckedIOException e) {
            LOG.error("a record of {} is lost: {}: {}", id, record, e.getMessage());
        }
    }

    private void sendAll() {
        Sender sending = new Sender();
        try {
            while (!closing) {
                try {
                    sending.round();
                } catch (UncheckedIOException unwritable) {
                    // As on a full disk: there may be room later.
                    LOG.error("the records of {} wait to be written: {}", id, unwritable.getMessage());
                    TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
                }
            }
        } catch (InterruptedException closed) {
            // Waiting records are in the file.
        }
    }

    /**
     * Publishes what waits, and everything again if the first of it is not confirmed in time: other records may have
     * been published since, which the gateway does not store as long as that one is missing.
     */
    private final class Sender {
        private long forcedTo;
        private long publishedTo;
        private long first;
        private long sinceNanos;
        private long connects = -1;

        void round() throws InterruptedException {
            long last = outbox.awaitAfter(forcedTo, POLL_MILLIS);
            if (last > forcedTo) {
                outbox.force();
                forcedTo = last;
            }
            outbox.sent(confirmed.get());
            reportLink();
            List<Outbox.Entry> entries = gateway.isUp() ? outbox.first(WINDOW, 0) : List.of();
            if (entries.isEmpty()) {
                return;
            }
            long oldest = entries.get(0).number();
            boolean late = oldest == first && clock.nanoTime() - sinceNanos > AGAIN_NANOS;
            boolean again = late || connects != gateway.connects();
            if (again || oldest != first) {
                first = oldest;
                sinceNanos = clock.nanoTime();
                connects = gateway.connects();
            }
            for (Outbox.Entry entry : entries) {
                if (entry.number() <= forcedTo && (again || entry.number() > publishedTo)) {
                    publish(entry, first);
                    publishedTo = Math.max(publishedTo, entry.number());
                }
            }
        }
    }

    private void publish(Outbox.Entry entry, long first) {
        JsonObject record = JsonRecord.of(entry.record())
                .copy()
                .put("number", entry.number())
                .put("first", first);
        gateway.publish(Message.event(topic(entry.topic()), record.toString()));
    }

    private void confirmed(Message message) {
        try {
            long number = new Received(message.payload()).members().number("number", 0);
            long last = outbox.last();
            if (number > last) {
                throw new IllegalArgumentException(
                        "it confirms record " + number + ", but the last one here is " + last);
            }
            confirmed.accumulateAndGet(number, Math::max);
        } catch (IllegalArgumentException unreadable) {
            ignore(message, unreadable);
        }
    }

    private void reportLink() {
        String now = gateway.isUp() ? "the gateway's broker can be reached" : gateway.describe();
        if (!now.equals(link)) {
            link = now;
            linkListener.accept(now + "; " + waiting(outbox.size()));
        }
    }

    private static String waiting(int records) {
        return switch (records) {
            case 0 -> "nothing waits to be sent";
            case 1 -> "1 record waits to be sent";
            default -> records + " records wait to be sent";
        };
    }

    // To the device

    private void carryAll(EdgeShell shell) {
        try {
            while (!closing) {
                Message next = received.take();
                try {
                    take(next, shell);
                } catch (IllegalArgumentException | ModelException unreadable) {
                    ignore(next, unreadable);
                }
            }
        } catch (InterruptedException closed) {
            // The device is being closed.
        }
    }

    private void take(Message message, EdgeShell shell) throws InterruptedException {
        if (message.payload().isEmpty()) {
            // The device was taken out of the fleet.
            return;
        }
        Received record = new Received(message.payload());
        if (message.topic().equals(topic("command"))) {
            obey(record, shell);
        } else if (record.members().number("sequence", 0) >= carried.last(id)) {
            // A state from before the last command is out of date.
            shell.stand(record.standing());
        }
    }

    private void obey(Received record, EdgeShell shell) throws InterruptedException {
        long sequence = record.members().number("sequence", 0);
        String problem = "";
        try {
            if (!carried.take(id, sequence)) {
                return;
            }
            if (record.members().number("deadlineMillis", 0) < wall.millis()) {
                problem = "the command arrived after its deadline";
            } else {
                long visit = record.members().number("visit", 0);
                // A visit that has yet to begin follows others, which are over.
                shell.leave(record.members().truth("function") ? visit - 1 : visit);
                carryOut(record, sequence, shell);
            }
        } catch (IllegalArgumentException | ModelException | UncheckedIOException e) {
            problem = String.valueOf(e.getMessage());
        }
        if (!problem.isEmpty()) {
            answered(sequence, EdgeShell.Result.FAILED, problem, Optional.empty());
        }
    }

    private static void carryOut(Received record, long sequence, EdgeShell shell) throws InterruptedException {
        switch (record.members().text("kind")) {
            case "send" -> shell.send(sequence, record.step(), record.members().values("values"));
            case "run" ->
                shell.run(
                        sequence,
                        record.members().text("effect"),
                        record.members().values("values"));
            case "locate" -> shell.locate(sequence);
            default ->
                throw new IllegalArgumentException("the kind of the command is '"
                        + record.members().text("kind") + "'; known are send, run and locate");
        }
    }

    private static void ignore(Message message, RuntimeException why) {
        LOG.warn("a message on {} is ignored: {}", message.topic(), why.getMessage());
    }

    /** Ends; what is not published yet is in the file. Close the shell afterwards. Idempotent. */
    @Override
    public synchronized void close() {
        closing = true;
        Thread receiving = carrier;
        Thread sending = sender;
        if (receiving != null) {
            receiving.interrupt();
            Threads.join(receiving, END_LIMIT);
        }
        if (sending != null) {
            Threads.join(sending, END_LIMIT);
        }
        gateway.close();
        outbox.close();
        carried.close();
    }
}
