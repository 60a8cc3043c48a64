package org.evoloop.fleet.stream;

import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import org.apache.kafka.clients.CommonClientConfigs;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.AdminClientConfig;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.serialization.ByteArrayDeserializer;
import org.apache.kafka.common.serialization.ByteArraySerializer;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.apache.kafka.common.serialization.StringSerializer;

/**
 * A Kafka cluster, and how its clients connect to it, such as with TLS and a password.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class KafkaCluster {
    /** Kafka's clients share the names of what all of them need: addresses, timeouts, TLS and SASL. */
    private static final Set<String> COMMON = AdminClientConfig.configNames();

    private final String bootstrap;
    private final Map<String, String> settings;
    /** Where the settings are from, for messages; empty if there are none. */
    private final String from;

    private KafkaCluster(String bootstrap, Map<String, String> settings, String from) {
        this.bootstrap = bootstrap;
        this.settings = Map.copyOf(settings);
        this.from = from;
    }

    /** A cluster that needs no settings; {@code bootstrap} is a broker's address, as HOST:PORT. */
    public static KafkaCluster at(String bootstrap) {
        return new KafkaCluster(bootstrap, Map.of(), "");
    }

    /**
     * A cluster whose clients have the settings in {@code file}, a file of properties such as Kafka's own tools take with
     * {@code --command-config}: those that all of Kafka's clients have, such as {@code security.protocol}.
     *
     * @throws FleetException if the file cannot be read, or contains another setting; the message names all of these
     */
    public static KafkaCluster at(String bootstrap, Path file) {
        Properties properties = read(file);
        Map<String, String> settings = new TreeMap<>();
        List<String> problems = new ArrayList<>();
        for (String name : properties.stringPropertyNames()) {
            if (name.equals(CommonClientConfigs.BOOTSTRAP_SERVERS_CONFIG)) {
                problems.add("  " + name + ": leave it out, since --bootstrap gives it");
            } else if (COMMON.contains(name)) {
                settings.put(name, properties.getProperty(name));
            } else if (ConsumerConfig.configNames().contains(name)
                    || ProducerConfig.configNames().contains(name)) {
                problems.add(
                        "  " + name + ": leave it out, since the fleet sets what only consumers or producers have");
            } else {
                problems.add("  " + name + ": Kafka's clients have no such setting; is it misspelled?");
            }
        }
        if (!problems.isEmpty()) {
            problems.sort(null);
            throw new FleetException("--kafka-config: " + file + " cannot be used:\n" + String.join("\n", problems));
        }
        return new KafkaCluster(bootstrap, settings, file.toString());
    }

    private static Properties read(Path file) {
        Properties properties = new Properties();
        try {
            properties.load(new StringReader(Files.readString(file)));
        } catch (NoSuchFileException e) {
            throw new FleetException("--kafka-config: there is no file " + file);
        } catch (CharacterCodingException | IllegalArgumentException e) {
            throw new FleetException("--kafka-config: " + file + " is not a file of properties, NAME=VALUE, in UTF-8");
        } catch (IOException e) {
            throw new FleetException("--kafka-config: " + file + " cannot be read: " + e.getMessage());
        }
        return properties;
    }

    /** The address of a broker, as HOST:PORT. */
    public String bootstrap() {
        return bootstrap;
    }

    /** What to check if no broker answers as it should, for the end of a message. */
    public String hint() {
        return from.isEmpty()
                ? "Is it running, is --bootstrap its address, and does it need no --kafka-config, as for TLS?"
                : "Is it running, is --bootstrap its address, and is " + from + " right?";
    }

    /** The settings of a client: the cluster's, and {@code own}, which win. */
    public Map<String, Object> with(Map<String, Object> own) {
        Map<String, Object> all = new HashMap<>(settings);
        all.put(CommonClientConfigs.BOOTSTRAP_SERVERS_CONFIG, bootstrap);
        all.putAll(own);
        return all;
    }

    /**
     * A client that looks after topics.
     *
     * @throws FleetException if the address or a setting is wrong
     */
    public Admin admin(Map<String, Object> own) {
        return connect(Admin::create, own);
    }

    /**
     * A client that reads.
     *
     * @throws FleetException if the address or a setting is wrong
     */
    public KafkaConsumer<String, byte[]> consumer(Map<String, Object> own) {
        return connect(all -> new KafkaConsumer<>(all, new StringDeserializer(), new ByteArrayDeserializer()), own);
    }

    /**
     * A client that writes.
     *
     * @throws FleetException if the address or a setting is wrong
     */
    public KafkaProducer<String, byte[]> producer(Map<String, Object> own) {
        return connect(all -> new KafkaProducer<>(all, new StringSerializer(), new ByteArraySerializer()), own);
    }

    private <C> C connect(Function<Map<String, Object>, C> client, Map<String, Object> own) {
        try {
            return client.apply(with(own));
        } catch (KafkaException e) {
            throw unusable(e);
        }
    }

    /** The reason why a client could not be made; its causes say more than Kafka's "Failed to construct". */
    FleetException unusable(KafkaException failure) {
        Throwable cause = failure;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        String why =
                cause instanceof NoSuchFileException ? "there is no file " + cause.getMessage() : cause.getMessage();
        String settings = from.isEmpty() ? "" : ", or the settings in " + from + " are wrong";
        return new FleetException(
                "'" + bootstrap + "' is not the address of a Kafka broker, HOST:PORT" + settings + ": " + why);
    }
}
