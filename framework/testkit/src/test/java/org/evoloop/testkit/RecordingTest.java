package org.evoloop.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.LightBulb;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Journal;
import org.evoloop.journal.JournalException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A day of the light bulb, replayed with the same models and with others. */
class RecordingTest {
    private static final Path MODELS = Path.of(System.getProperty("evoloop.root"), "models");

    @TempDir
    private Path folder;

    private Path sunday;

    @BeforeEach
    void aDayOfTheLamp() {
        sunday = folder.resolve("sunday");
        try (ConverterHarness lamp = ConverterHarness.of(new LightBulb())
                .with(new RecordingExecute("Device", "switch"))
                .with(Journal.in(sunday))
                .start()) {
            lamp.press("switch").press("switch").until("off");
            lamp.press("switch").press("switch").press("switch").press("switch");
        }
    }

    /** As in docs/testing.md. */
    @Test
    void theLampStillDecidesAsOnSunday() {
        ModelFile file = ModelFile.read(MODELS.resolve("light-bulb.xml"));
        Recording.in(sunday)
                .withProperties(MODELS.resolve("light-bulb.properties.txt"))
                .replay(new ModelPair(file.pick("original"), file.pick("new")))
                .expectSameDecisions()
                .expectPropertiesKept();
    }

    private static ModelPair without(String state) {
        StateMachineBuilder evolved = StateMachine.named("without " + state)
                .initial("off")
                .transition("off", "switch", "on")
                .transition("on", "switch", "wait")
                .transition("wait", "timeout", "off")
                .transition("wait", "switch", "off");
        return new ModelPair(PaperModels.lightBulb().original(), evolved.build());
    }

    @Test
    void whatOthersDecideOtherwiseIsListedWithBothReasons() {
        Recording.Replay replay = Recording.in(sunday).replay(without("incandescentOn"));
        assertThat(replay.events()).isEqualTo(7);
        assertThat(replay.differences()).hasSize(2);
        assertThatThrownBy(replay::expectSameDecisions)
                .isInstanceOf(AssertionError.class)
                .hasMessageStartingWith("2 of 7 events are decided differently from the recording:\n")
                .hasMessageContaining("switch (controller)\n")
                .hasMessageContaining("\n    then  (on, wait) -> (on, incandescentOn): new-function\n"
                        + "    now   (on, wait) -> (off, off), sends switch: existing-function");
        assertThat(replay.expectPropertiesKept()).as("there are no properties").isSameAs(replay);
    }

    @Test
    void aBrokenPropertyIsReportedWithItsEvent() throws IOException {
        Path file = Files.writeString(
                folder.resolve("lamp.txt"), "never dark: never (off and event timeout)\nalways can on\n");
        Recording.Replay replay = Recording.in(sunday)
                .withProperties(file)
                .replay(PaperModels.lightBulb())
                .expectSameDecisions();
        assertThat(replay.broken()).hasSize(1);
        assertThatThrownBy(replay::expectPropertiesKept)
                .isInstanceOf(AssertionError.class)
                .hasMessageStartingWith("1 of 2 properties in " + file + " are broken:\n  'never dark' (line 1) at ")
                .hasMessageEndingWith(", by timeout (timer), in (off, off)");
    }

    @Test
    void whatIsNotThereIsNamed() {
        assertThatThrownBy(() -> Recording.in(folder).replay(PaperModels.lightBulb()))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining(folder + " is not a journal");
        Path none = folder.resolve("none.txt");
        assertThatThrownBy(() -> Recording.in(sunday).withProperties(none).replay(PaperModels.lightBulb()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(none + " cannot be read as text");
    }
}
