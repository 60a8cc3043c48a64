package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;
import org.evoloop.LightBulb;
import org.evoloop.RecordingExecute;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What Java Flight Recorder records about the paper's light bulb, whose timer turns it off. */
class FlightLogTest {
    private final ManualClock clock = new ManualClock();
    private final PushMonitor wallSwitch = new PushMonitor("WallSwitch");
    private final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("lamp", clock).withoutThreads());

    @TempDir
    Path folder;

    FlightLogTest() {
        converter.addMonitor(wallSwitch);
        converter.addExecute(new RecordingExecute("Lamp", "switch"));
        converter.addKnowledge(new LightBulb());
        converter.build();
        converter.start();
    }

    private void press() throws InterruptedException {
        wallSwitch.press("switch");
        converter.observe(wallSwitch);
        converter.step();
    }

    private static Stream<RecordedEvent> of(List<RecordedEvent> all, String type) {
        return all.stream().filter(event -> event.getEventType().getName().equals("org.evoloop." + type));
    }

    @Test
    void eachPhaseOfEachEventIsRecorded() throws Exception {
        Path file = folder.resolve("lamp.jfr");
        try (Recording recording = new Recording()) {
            recording.start();
            press();
            press();
            press();
            press();
            converter.close();
            recording.stop();
            recording.dump(file);
        }
        List<RecordedEvent> all = RecordingFile.readAllEvents(file);

        assertThat(of(all, "Conversion"))
                .extracting(event -> event.getString("converter") + ": " + event.getString("occurrence") + " "
                        + event.getString("before") + " -> " + event.getString("after") + " "
                        + event.getString("outcome"))
                .containsExactly(
                        "lamp: switch (controller) (off, off) -> (on, on) handled",
                        "lamp: switch (controller) (on, on) -> (on, wait) handled",
                        "lamp: switch (controller) (on, wait) -> (on, incandescentOn) handled",
                        "lamp: switch (controller) (on, incandescentOn) -> (off, off) handled");
        assertThat(of(all, "Conversion")).allMatch(event -> !event.getDuration().isNegative());
        assertThat(of(all, "Phase").map(event -> event.getString("phase") + " by " + event.getString("component")))
                .hasSize(12)
                .startsWith("analyze by EventAnalyze", "plan by EventPlan", "execute by Lamp");
        assertThat(of(all, "Observed").map(event -> event.getString("admission")))
                .hasSize(4)
                .containsOnly("queued");
        assertThat(of(all, "Work").map(event -> event.getString("kind") + " " + event.getString("what")))
                .containsExactly(
                        "SEND off --switch--> on",
                        "FUNCTION wait",
                        "FUNCTION incandescentOn",
                        "SEND on --switch--> off");
    }

    @Test
    void withoutARecordingThereAreNone() throws Exception {
        press();
        Path file = folder.resolve("lamp.jfr");
        try (Recording recording = new Recording()) {
            recording.start();
            recording.stop();
            recording.dump(file);
        }
        converter.close();
        assertThat(RecordingFile.readAllEvents(file))
                .noneMatch(event -> event.getEventType().getName().startsWith("org.evoloop."));
    }
}
