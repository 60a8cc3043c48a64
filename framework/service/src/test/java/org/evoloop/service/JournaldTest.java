package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.LoggingEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JournaldTest {
    private static String line(Level level, String message, Throwable cause) {
        return new Journald()
                .doLayout(new LoggingEvent("", new LoggerContext().getLogger("test"), level, message, cause, null));
    }

    @ParameterizedTest
    @CsvSource({"ERROR,3", "WARN,4", "INFO,6", "DEBUG,7", "TRACE,7"})
    void aLineBeginsWithItsLevel(String level, int priority) {
        assertThat(line(Level.valueOf(level), "the lamp is gone", null))
                .isEqualTo("<" + priority + ">the lamp is gone\n");
    }

    @Test
    void everyLineOfAMessageAndOfAStackTraceHasIt() {
        String text = line(Level.ERROR, "two\nlines", new IllegalStateException("no lamp"));

        assertThat(text).startsWith("<3>two\n<3>lines\n<3>java.lang.IllegalStateException: no lamp\n<3>\tat ");
        assertThat(text.lines()).allMatch(line -> line.startsWith("<3>"));
    }
}
