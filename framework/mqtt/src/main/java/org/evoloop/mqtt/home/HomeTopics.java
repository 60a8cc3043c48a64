package org.evoloop.mqtt.home;

/**
 * The topics of one converter.
 *
 * @param id its name at the broker
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

    /** The state of the converter and its device, as JSON. */
    String state() {
        return own("state");
    }

    /** What an entity shows, as JSON. */
    String entity(String key) {
        return own(key);
    }

    /** Takes a command for an entity. */
    String command(String key) {
        return own(key + "/set");
    }

    /** Takes the name of a mode for an entity. */
    String mode(String key) {
        return own(key + "/mode/set");
    }

    /** Takes the humidity that a humidifier is to reach. */
    String humidity(String key) {
        return own(key + "/humidity/set");
    }

    /** That something has failed, as JSON. */
    String failure() {
        return own("failure");
    }

    /** The converter's diagnostics, as JSON. */
    String diagnostics() {
        return own("diagnostics");
    }

    /** The report of a shadow, as JSON. */
    String shadow() {
        return own("shadow");
    }

    /** Takes the command to promote the shadow. */
    String promote() {
        return own("shadow/promote");
    }

    /** The outcome of an event, as JSON. */
    String decision() {
        return own("decision");
    }

    /** Takes the names of events: a control of the controller was operated. */
    String press() {
        return own("press");
    }

    /** What became of each event that {@link #press} took, as JSON. */
    String outcome() {
        return own("outcome");
    }

    /** Takes {@code ON} and {@code OFF}: whether events are converted. */
    String converting() {
        return own("converting/set");
    }

    /** Takes the name of the chosen option. */
    String choice(String key) {
        return own("choice/" + key + "/set");
    }

    /** Takes the value of a setting. */
    String setting(String key) {
        return own("setting/" + key + "/set");
    }

    /** What the broker keeps of the settings, as JSON. */
    String settings() {
        return own("settings");
    }

    /** A picture, as SVG. */
    String picture(String key) {
        return own("picture/" + key);
    }

    /** The discovery topic, from which Home Assistant reads the entities. */
    String config() {
        return discovery + "/device/evoloop_" + id + "/config";
    }

    /** The topic on which Home Assistant announces its start. */
    String birth() {
        return discovery + "/status";
    }
}
