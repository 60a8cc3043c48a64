/** Where a marker is that a camera on the robot sees. */
@SuppressWarnings("module")
module org.evoloop.roomba.camera {
    requires static org.jspecify;
    // Its commands, for a program that has them.
    requires static info.picocli;
    // The machine's own, loaded when it is first asked for.
    requires static opencv;
    requires transitive org.evoloop.core;
    requires org.evoloop.natives;
    requires com.sun.jna;
    requires java.desktop;
    requires org.slf4j;

    exports org.evoloop.roomba.camera;
    exports org.evoloop.roomba.camera.live;
    exports org.evoloop.roomba.camera.vision;

    // The program's module is built after this one.
    exports org.evoloop.roomba.camera.tool to
            org.evoloop.roomba;

    opens org.evoloop.roomba.camera.tool to
            info.picocli;
}
