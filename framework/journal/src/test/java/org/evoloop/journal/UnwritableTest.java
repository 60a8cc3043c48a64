package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A running converter whose journal can no longer be written. */
@Timeout(60)
class UnwritableTest {
    @TempDir
    private Path directory;

    @Test
    void whoeverPressesIsToldAndTheStatusNamesTheJournal() throws Exception {
        Path path = directory.resolve("journal");
        PushMonitor buttons = new PushMonitor("Buttons");
        try (Clock clock = new SystemClock();
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("ring", clock))) {
            converter.addMonitor(buttons);
            converter.addExecute(new EventExecute("Device") {
                @Override
                protected Set<String> sendableEvents() {
                    return Set.of("next");
                }

                @Override
                protected void send(Step step) {}
            });
            converter.addKnowledge(new Ring(Ring.MODELS));
            converter.journal(Journal.in(path).withSegmentBytes(1 << 16));
            converter.build();
            converter.start();
            Files.move(path, directory.resolve("elsewhere"));

            assertThatThrownBy(() -> {
                        while (true) {
                            // Large, so that few of them fill a segment.
                            buttons.press("next", Values.of("note", "x".repeat(4000)));
                            await().until(() -> converter.status().queue().depth() == 0);
                        }
                    })
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage(
                            "the converter ring cannot write its journal, so next is refused; make room on its disk");

            ConverterStatus status = converter.status();
            assertThat(status.queue().refused()).isEqualTo(1);
            assertThat(status.faults()).singleElement().satisfies(fault -> {
                assertThat(fault.part()).isEqualTo("journal");
                assertThat(fault.failures()).isEqualTo(1);
                assertThat(fault.lastFailure()).startsWith("the journal " + path + " cannot be written: ");
            });

            Files.move(directory.resolve("elsewhere"), path);
            await().ignoreExceptions().until(() -> {
                buttons.press("next");
                return true;
            });
            assertThat(converter.status().troubles()).as("it is written again").isEmpty();
        }
    }
}
