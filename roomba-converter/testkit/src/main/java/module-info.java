/** A simulated Roomba for JUnit 5 tests. */
module org.evoloop.roomba.testkit {
    requires static org.jspecify;
    requires transitive org.evoloop.roomba.simulator;
    // The version is chosen by the test's author.
    requires static transitive org.junit.jupiter.api;

    exports org.evoloop.roomba.testkit;
}
