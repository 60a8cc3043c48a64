/** Learns the state machine of a device from the device itself. */
module org.evoloop.learn {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires de.learnlib.api;
    requires de.learnlib.common.counterexample;
    requires de.learnlib.algorithm.ttt;
    requires net.automatalib.api;
    requires net.automatalib.core;
    requires net.automatalib.util;

    exports org.evoloop.learn;
}
