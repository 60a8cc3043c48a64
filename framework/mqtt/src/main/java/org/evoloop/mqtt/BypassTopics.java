package org.evoloop.mqtt;

import java.util.List;

/**
 * The topics on which a converter and its bypass publish their status for each other.
 *
 * @param base the common prefix, such as {@code evoloop/lamp/bypass}
 */
record BypassTopics(String base) {
    /** Whether the converter is connected. */
    String converter() {
        return base + "/converter";
    }

    /** Whether the bypass is connected. */
    String own() {
        return base + "/own";
    }

    /** The events passed on while the converter was gone, one per line, oldest first; empty if there are none. */
    String passed() {
        return base + "/passed";
    }

    /** How many of those events the converter has received. */
    String received() {
        return base + "/told";
    }

    static List<String> events(Message passed) {
        return passed.payload().lines().filter(event -> !event.isBlank()).toList();
    }
}
