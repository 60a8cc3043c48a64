package org.evoloop.fleet.broker;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicInteger;
import kafka.server.KafkaConfig;
import kafka.server.KafkaRaftServer;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.common.errors.BrokerIdNotRegisteredException;
import org.apache.kafka.common.errors.NotControllerException;
import org.apache.kafka.common.errors.UnsupportedVersionException;
import org.apache.kafka.common.utils.Time;
import org.apache.kafka.metadata.storage.Formatter;
import org.apache.kafka.server.common.Feature;

/**
 * A Kafka broker in this process, for demos and tests: one node that is broker and controller (KRaft), without
 * replicas, on two free ports of the loopback interface.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class LocalBroker implements AutoCloseable {
    private static final int NODE = 1;
    private static final String FORMATTED = "meta.properties";
    private static final long ELECTION_MILLIS = 100;
    private static final int FIRST_PORT = 20_000;
    private static final int PORTS = 12_000;
    private static final AtomicInteger NEXT_PORT =
            new AtomicInteger(ThreadLocalRandom.current().nextInt(PORTS));

    private final KafkaRaftServer server;
    private final String bootstrap;

    private LocalBroker(KafkaRaftServer server, String bootstrap) {
        this.server = server;
        this.bootstrap = bootstrap;
    }

    /**
     * Starts it, which takes some seconds; data from an earlier run in {@code directory} is available again.
     *
     * @throws UncheckedIOException if the directory cannot be written
     */
    public static LocalBroker start(Path directory) {
        try {
            return start(directory, freePort(), freePort());
        } catch (IOException e) {
            throw new UncheckedIOException("the broker has no port: " + e.getMessage(), e);
        }
    }

    /** Starts it on these ports, for example those of an earlier run. */
    public static LocalBroker start(Path directory, int port, int controllerPort) {
        return start(directory, port, controllerPort, Map.of());
    }

    /** @param others settings of a broker, which win */
    static LocalBroker start(Path directory, int port, int controllerPort, Map<String, String> others) {
        String bootstrap = "localhost:" + port;
        Properties settings = settings(directory, port, controllerPort);
        settings.putAll(others);
        boolean hasRun = Files.exists(directory.resolve(FORMATTED));
        format(directory);
        if (hasRun) {
            unregister(settings, controllerPort);
        }
        KafkaRaftServer server = new KafkaRaftServer(new KafkaConfig(settings, false), Time.SYSTEM);
        server.startup();
        return new LocalBroker(server, bootstrap);
    }

    /**
     * Starts only the controller and has it forget the broker of an earlier run. A killed broker otherwise counts as
     * running until its session ends, and then its partitions have no leader for a moment. Kafka 4.3.1 takes them for
     * deleted then and drops the ends of their transactions, which stay open forever (KAFKA-20734).
     */
    private static void unregister(Properties settings, int controllerPort) {
        Properties alone = new Properties();
        alone.putAll(settings);
        alone.put("process.roles", "controller");
        alone.put("listeners", "CONTROLLER://localhost:" + controllerPort);
        alone.remove("inter.broker.listener.name");
        KafkaRaftServer controller = new KafkaRaftServer(new KafkaConfig(alone, false), Time.SYSTEM);
        controller.startup();
        try (Admin admin = Admin.create(Map.of("bootstrap.controllers", "localhost:" + controllerPort))) {
            while (!unregister(admin)) {
                Thread.sleep(ELECTION_MILLIS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while the broker started", e);
        } finally {
            controller.shutdown();
            controller.awaitShutdown();
        }
    }

    /** False if the controller cannot do it yet, because it is not elected, or has not read its metadata. */
    private static boolean unregister(Admin admin) throws InterruptedException {
        try {
            admin.unregisterBroker(NODE).all().get();
            return true;
        } catch (ExecutionException e) {
            if (e.getCause() instanceof BrokerIdNotRegisteredException) {
                return true;
            }
            if (e.getCause() instanceof NotControllerException
                    || e.getCause() instanceof UnsupportedVersionException) {
                return false;
            }
            throw new IllegalStateException("the earlier run's broker cannot be unregistered: " + e.getMessage(), e);
        }
    }

    private static Properties settings(Path directory, int port, int controllerPort) {
        Properties settings = new Properties();
        settings.put("process.roles", "broker,controller");
        settings.put("node.id", String.valueOf(NODE));
        settings.put("log.dirs", directory.toString());
        settings.put("listeners", "PLAINTEXT://localhost:" + port + ",CONTROLLER://localhost:" + controllerPort);
        settings.put("controller.listener.names", "CONTROLLER");
        settings.put("controller.quorum.voters", NODE + "@localhost:" + controllerPort);
        settings.put("inter.broker.listener.name", "PLAINTEXT");
        // A single node has no replicas, and no other members to wait for.
        settings.put("offsets.topic.replication.factor", "1");
        settings.put("transaction.state.log.replication.factor", "1");
        settings.put("transaction.state.log.min.isr", "1");
        settings.put("group.initial.rebalance.delay.ms", "0");
        // Each partition of these costs time at the start.
        settings.put("offsets.topic.num.partitions", "4");
        settings.put("transaction.state.log.num.partitions", "4");
        settings.put("auto.create.topics.enable", "false");
        // Replayed records keep their original times, which may be long ago.
        settings.put("log.retention.ms", "-1");
        settings.put("group.min.session.timeout.ms", "1000");
        settings.put("log.cleaner.dedupe.buffer.size", "2000000");
        return settings;
    }

    private static void format(Path directory) {
        try {
            Files.createDirectories(directory);
            new Formatter()
                    .setPrintStream(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8))
                    .setSupportedFeatures(Feature.PRODUCTION_FEATURES)
                    .setNodeId(NODE)
                    .setClusterId("ZXZvbG9vcC1mbGVldC0wMQ")
                    .setDirectories(List.of(directory.toString()))
                    .setMetadataLogDirectory(directory.toString())
                    .setControllerListenerName("CONTROLLER")
                    .setIgnoreFormatted(true)
                    .run();
        } catch (IOException e) {
            throw new UncheckedIOException(directory + " cannot be used by the broker: " + e.getMessage(), e);
        } catch (Exception e) {
            throw new IllegalStateException(directory + " cannot be formatted for the broker: " + e.getMessage(), e);
        }
    }

    /**
     * A port of this computer that is free now; another program may take it before it is used. It is none of those that
     * systems give to connections: while the broker is stopped, no connection takes its port, not even that of a client
     * that tries to reach it.
     */
    public static int freePort() throws IOException {
        IOException taken = new IOException("none was tried");
        for (int tries = 0; tries < PORTS; tries++) {
            int port = FIRST_PORT + Math.floorMod(NEXT_PORT.getAndIncrement(), PORTS);
            try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                return socket.getLocalPort();
            } catch (IOException next) {
                taken = next;
            }
        }
        throw taken;
    }

    /** Its address for clients, as HOST:PORT. */
    public String bootstrap() {
        return bootstrap;
    }

    /** Stops it; its data remains in the directory. */
    @Override
    public void close() {
        server.shutdown();
        server.awaitShutdown();
    }
}
