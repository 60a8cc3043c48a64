/** The Roomba converter: the program, and the function move. */
module org.evoloop.roomba {
    requires static org.jspecify;
    requires ch.qos.logback.classic;
    requires ch.qos.logback.core;
    requires org.evoloop.device;
    requires org.evoloop.program;
    requires org.evoloop.roomba.camera;
    requires org.evoloop.roomba.session;
    requires org.evoloop.roomba.simulator;
    requires org.evoloop.svg;
    requires org.slf4j;

    opens org.evoloop.roomba to
            info.picocli;

    provides org.evoloop.device.ConnectionKind with
            org.evoloop.roomba.RoombaKind;
}
