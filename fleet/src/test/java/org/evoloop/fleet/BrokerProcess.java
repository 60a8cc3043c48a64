package org.evoloop.fleet;

import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import org.evoloop.fleet.broker.LocalBroker;

/** A broker in a separate process, which can be killed; its arguments are directory, port and controller's port. */
public final class BrokerProcess {
    private BrokerProcess() {}

    public static void main(String[] arguments) throws InterruptedException {
        try (LocalBroker broker = LocalBroker.start(
                Path.of(arguments[0]), Integer.parseInt(arguments[1]), Integer.parseInt(arguments[2]))) {
            System.out.println("broker at " + broker.bootstrap());
            new CountDownLatch(1).await();
        }
    }
}
