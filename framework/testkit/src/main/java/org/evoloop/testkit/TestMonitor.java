package org.evoloop.testkit;

import org.evoloop.converter.PushMonitor;

/** Reports the events that a test gives it. */
final class TestMonitor extends PushMonitor {
    TestMonitor() {
        super("Test");
    }

    void pressedOnDevice(String event, boolean deviceActed) {
        push(fromPanel(event, deviceActed));
    }

    void done(String event) {
        push(fromDevice(event));
    }

    void found(String state) {
        push(foundIn(state));
    }
}
