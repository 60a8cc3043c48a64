/** A simulated Roomba for anybody's JUnit 5 test. */
module org.evoloop.roomba.testkit {
    requires static org.jspecify;
    requires transitive org.evoloop.roomba.simulator;
    // In the version of whoever writes the test.
    requires static transitive org.junit.jupiter.api;

    exports org.evoloop.roomba.testkit;
}
