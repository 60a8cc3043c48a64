package org.evoloop.fleet.broker;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.evoloop.mqtt.Certificate;

/** A broker whose clients need TLS and a password. */
public final class SecureBroker implements AutoCloseable {
    private static final String JAAS = "org.apache.kafka.common.security.plain.PlainLoginModule required";

    private final LocalBroker broker;
    private final Path directory;
    private final Certificate certificate;

    private SecureBroker(LocalBroker broker, Path directory, Certificate certificate) {
        this.broker = broker;
        this.directory = directory;
        this.certificate = certificate;
    }

    public static SecureBroker start(Path directory) throws Exception {
        Certificate certificate = Certificate.of(directory, "broker", "dns:localhost");
        int port = LocalBroker.freePort();
        int controllerPort = LocalBroker.freePort();
        Map<String, String> settings = new HashMap<>(clients(certificate.store(), "broker", "between brokers"));
        String jaas = settings.remove("sasl.jaas.config");
        settings.put("listeners", "SASL_SSL://localhost:" + port + ",CONTROLLER://localhost:" + controllerPort);
        settings.remove("security.protocol");
        settings.put("listener.security.protocol.map", "SASL_SSL:SASL_SSL,CONTROLLER:PLAINTEXT");
        settings.put("inter.broker.listener.name", "SASL_SSL");
        settings.put("sasl.enabled.mechanisms", "PLAIN");
        settings.put("sasl.mechanism.inter.broker.protocol", settings.remove("sasl.mechanism"));
        settings.put(
                "listener.name.sasl_ssl.plain.sasl.jaas.config",
                jaas.replace(";", " user_broker=\"between brokers\" user_fleet=\"secret\";"));
        settings.put("ssl.keystore.location", certificate.store().toString());
        settings.put("ssl.keystore.password", Certificate.PASSWORD);
        settings.put("ssl.key.password", Certificate.PASSWORD);
        return new SecureBroker(
                LocalBroker.start(directory.resolve("broker"), port, controllerPort, settings), directory, certificate);
    }

    private static Map<String, String> clients(Path trusted, String user, String password) {
        return Map.of(
                "security.protocol",
                "SASL_SSL",
                "sasl.mechanism",
                "PLAIN",
                "sasl.jaas.config",
                JAAS + " username=\"" + user + "\" password=\"" + password + "\";",
                "ssl.truststore.location",
                trusted.toString(),
                "ssl.truststore.password",
                Certificate.PASSWORD);
    }

    public String bootstrap() {
        return broker.bootstrap();
    }

    /** A file of settings for clients that trust the certificate in {@code store}. */
    public Path settings(Path store, String password) throws IOException {
        StringBuilder text = new StringBuilder();
        clients(store, "fleet", password)
                .forEach((name, value) ->
                        text.append(name).append('=').append(value).append('\n'));
        return Files.writeString(Files.createTempFile(directory, "clients", ".properties"), text);
    }

    /** The right settings. */
    public Path settings() throws IOException {
        return settings(certificate.store(), "secret");
    }

    public Certificate certificate() {
        return certificate;
    }

    @Override
    public void close() {
        broker.close();
    }
}
