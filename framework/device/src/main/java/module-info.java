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
            org.evoloop.device.GpioKind,
            org.evoloop.device.HomeAssistantKind,
            org.evoloop.device.HttpKind,
            org.evoloop.device.LineKind,
            org.evoloop.device.MqttKind,
            org.evoloop.device.ProgramKind,
            org.evoloop.device.WebhookKind;
}
