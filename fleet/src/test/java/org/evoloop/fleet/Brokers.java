package org.evoloop.fleet;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.fleet.broker.LocalBroker;

/** One broker for all test classes of a run, since it takes seconds to start. Each test has its own fleet. */
public final class Brokers {
    private static String bootstrap = "";
    private static int fleets;

    private Brokers() {}

    /** Its address; it is stopped with the process. */
    public static synchronized String shared() throws IOException {
        if (bootstrap.isEmpty()) {
            Path directory = Files.createTempDirectory(Path.of("target"), "broker-");
            LocalBroker broker = LocalBroker.start(directory.toAbsolutePath());
            Runtime.getRuntime().addShutdownHook(new Thread(broker::close));
            bootstrap = broker.bootstrap();
        }
        return bootstrap;
    }

    /** The name of a fleet that no other test uses. */
    public static synchronized String freshFleet() {
        fleets++;
        return "test" + fleets;
    }
}
