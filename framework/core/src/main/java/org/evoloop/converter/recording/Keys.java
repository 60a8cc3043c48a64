package org.evoloop.converter.recording;

import org.slf4j.Logger;
import org.slf4j.event.Level;
import org.slf4j.spi.LoggingEventAware;
import org.slf4j.spi.LoggingEventBuilder;

/** Which converter a line of the log is about, and which event, as key-values for programs that read logs. */
final class Keys {
    static final String CONVERTER = "converter";
    static final String EVENT = "event";

    private Keys() {}

    /** @param event empty if it is about none */
    static LoggingEventBuilder at(Logger log, Level level, String converter, String event) {
        LoggingEventBuilder line = log.atLevel(level);
        if (!(log instanceof LoggingEventAware)) {
            // A simple logger would write them into the message.
            return line;
        }
        LoggingEventBuilder keyed = line.addKeyValue(CONVERTER, converter);
        return event.isEmpty() ? keyed : keyed.addKeyValue(EVENT, event);
    }
}
