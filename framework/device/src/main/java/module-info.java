/** Device files: how a device and its controller are connected, without Java. */
module org.evoloop.device {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires org.evoloop.check;
    requires org.evoloop.config;
    requires transitive org.evoloop.console;
    requires org.evoloop.gpio;
    requires org.evoloop.homeassistant;
    requires org.evoloop.http;
    requires org.evoloop.line;
    requires transitive org.evoloop.mqtt;
    requires org.evoloop.page;
    requires org.evoloop.payload;
    requires org.evoloop.program;
    requires org.evoloop.serial;
    requires org.evoloop.service;
    requires transitive org.evoloop.testkit;
    requires org.evoloop.xmi;
    requires org.slf4j;
    requires org.snakeyaml.engine;

    exports org.evoloop.device;
    exports org.evoloop.device.file;

    uses org.evoloop.device.ConnectionKind;

    provides org.evoloop.device.ConnectionKind with
            org.evoloop.device.connection.GpioKind,
            org.evoloop.device.connection.HomeAssistantKind,
            org.evoloop.device.connection.HttpKind,
            org.evoloop.device.connection.LineKind,
            org.evoloop.device.connection.MqttKind,
            org.evoloop.device.connection.ProgramKind,
            org.evoloop.device.connection.WebhookKind;
}
