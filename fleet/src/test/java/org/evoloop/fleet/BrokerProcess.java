package org.evoloop.fleet;

import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.apache.kafka.clients.admin.Admin;
import org.evoloop.fleet.broker.LocalBroker;

/** A broker in a separate process, which can be killed; its arguments are directory, port and controller's port. */
public final class BrokerProcess {
    private BrokerProcess() {}

    /** Starts one with its data in {@code directory}, and waits until it runs. */
    public static Process start(Path directory, int port, int controllerPort) throws Exception {
        Process broker = TestProcess.start(
                directory.resolve("broker.log"),
                BrokerProcess.class,
                directory.resolve("broker").toString(),
                String.valueOf(port),
                String.valueOf(controllerPort));
        // The call returns as soon as the broker runs.
        try (Admin admin = Admin.create(Map.of(
                "bootstrap.servers",
                "localhost:" + port,
                "default.api.timeout.ms",
                "120000",
                "request.timeout.ms",
                "5000"))) {
            admin.describeCluster().nodes().get(120, TimeUnit.SECONDS);
        }
        return broker;
    }

    public static void main(String[] arguments) throws InterruptedException {
        try (LocalBroker broker = LocalBroker.start(
                Path.of(arguments[0]), Integer.parseInt(arguments[1]), Integer.parseInt(arguments[2]))) {
            System.out.println("broker at " + broker.bootstrap());
            new CountDownLatch(1).await();
        }
    }
}
