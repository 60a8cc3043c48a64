package org.evoloop.mqtt;

/**
 * The topics of one converter.
 *
 * @param id what it is called at the broker
 * @param discovery where Home Assistant looks for devices
 */
record HomeTopics(String id, String discovery) {
    private String own(String name) {
        return "evoloop/" + id + "/" + name;
    }

    /** {@code online} or {@code offline}. */
    String availability() {
        return own("availability");
    }

    /** How the converter and its device are, as JSON. */
    String state() {
        return own("state");
    }

    /** What the vacuum does, as JSON. */
    String vacuum() {
        return own("vacuum");
    }

    /** How the converter fares, as JSON. */
    String diagnostics() {
        return own("diagnostics");
    }

    /** What a shadow would have done, as JSON. */
    String shadow() {
        return own("shadow");
    }

    /** Puts the shadow in. */
    String promote() {
        return own("shadow/promote");
    }

    /** What became of an event, as JSON. */
    String decision() {
        return own("decision");
    }

    /** Takes the names of events: a control of the controller was operated. */
    String press() {
        return own("press");
    }

    /** Takes a command for the vacuum. */
    String vacuumCommand() {
        return own("vacuum/set");
    }

    /** Takes {@code ON} and {@code OFF}: whether events are converted. */
    String converting() {
        return own("converting/set");
    }

    /** Takes the name of what is chosen. */
    String choice(String key) {
        return own("choice/" + key + "/set");
    }

    /** Where Home Assistant reads what entities there are. */
    String config() {
        return discovery + "/device/evoloop_" + id + "/config";
    }

    /** Where Home Assistant tells that it has started. */
    String birth() {
        return discovery + "/status";
    }
}
