/** A simulated Roomba on a pseudo-terminal, in a simulated room, with a camera that programs can read. */
module org.evoloop.roomba.simulator {
    requires static org.jspecify;
    // Its commands, for a program that has them.
    requires static info.picocli;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.roomba.oi;
    requires org.evoloop.natives;
    requires java.desktop;
    requires jdk.httpserver;
    requires org.slf4j;

    exports org.evoloop.roomba.simulator;
    exports org.evoloop.roomba.simulator.body;
    exports org.evoloop.roomba.simulator.drawing;
    exports org.evoloop.roomba.simulator.eye;
    exports org.evoloop.roomba.simulator.robot;
    exports org.evoloop.roomba.simulator.room;
    exports org.evoloop.roomba.simulator.webcam;

    opens org.evoloop.roomba.simulator to
            info.picocli;
}
