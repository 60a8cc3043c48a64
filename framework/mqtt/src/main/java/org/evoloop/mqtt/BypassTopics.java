package org.evoloop.mqtt;

import java.util.List;

/**
 * Where a converter and its bypass tell each other how they are.
 *
 * @param base such as {@code evoloop/lamp/bypass}
 */
record BypassTopics(String base) {
    /** Whether the converter is there. */
    String converter() {
        return base + "/converter";
    }

    /** Whether the bypass is there. */
    String own() {
        return base + "/own";
    }

    /** The events that were passed on since the converter was gone, one a line, the oldest first; empty if none were. */
    String passed() {
        return base + "/passed";
    }

    /** How many of those events the converter has been told. */
    String told() {
        return base + "/told";
    }

    static List<String> events(Message passed) {
        return passed.payload().lines().filter(event -> !event.isBlank()).toList();
    }
}
