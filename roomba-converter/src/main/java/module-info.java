/** The Roomba converter: the program, and the function move. */
module org.evoloop.roomba {
    requires static org.jspecify;
    requires ch.qos.logback.classic;
    requires ch.qos.logback.core;
    requires info.picocli;
    requires org.evoloop.config;
    requires org.evoloop.console;
    requires org.evoloop.journal;
    requires org.evoloop.mqtt;
    requires org.evoloop.page;
    requires org.evoloop.roomba.camera;
    requires org.evoloop.roomba.session;
    requires org.evoloop.roomba.simulator;
    requires org.evoloop.service;
    requires org.evoloop.svg;
    requires org.evoloop.xmi;
    requires org.slf4j;

    opens org.evoloop.roomba to
            info.picocli;
}
