package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Journal;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.testkit.SimulatedDevice;
import org.evoloop.xmi.ModelReference;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** A lamp is learned from what its converter has recorded. */
@SuppressWarnings("NullAway.Init") // set before each test
class LearnFromJournalTest {
    private static final StateMachine LAMP = StateMachine.named("original")
            .initial("off")
            .state("dim")
            .transition("off", "switch", "on")
            .transition("on", "switch", "off")
            .transition("on", "burnOut", "off")
            .spontaneous("burnOut")
            .build();

    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private Path model;

    /** Twice it is switched on and off; then it burns out, and is dim after it was switched. */
    @BeforeEach
    void record() {
        model = folder.resolve("lamp.mmd");
        try (ConverterHarness lamp = ConverterHarness.of(new StateKnowledge(new ModelPair(LAMP, LAMP.withName("new"))))
                .with(SimulatedDevice.of(LAMP).buttons("burnOut").build())
                .with(Journal.in(folder.resolve("journal")))
                .start()) {
            lamp.press("switch").found("on").press("switch").found("off");
            lamp.press("switch").found("on").deviceDoes("burnOut").found("off");
            lamp.press("switch")
                    .advance(Duration.ofMinutes(1))
                    .found("on")
                    .press("switch")
                    .found("dim");
        }
    }

    private int learn(String... more) {
        List<String> all = new ArrayList<>(
                List.of("--from-journal", folder.resolve("journal").toString()));
        all.addAll(List.of(more));
        CommandLine command = Main.learning();
        command.setOut(new PrintWriter(out, true));
        command.setErr(new PrintWriter(err, true));
        return Main.run(command, all.toArray(String[]::new));
    }

    @Test
    void whatWasSeenIsProposedAndNothingElse() {
        assertThat(learn("--output=" + model)).isEqualTo(1);

        assertThat(out.toString())
                .contains(
                        "off --switch--> on: seen 2 times",
                        "on --switch--> off: seen once",
                        "on --switch--> dim: seen once",
                        "on --burnOut--> off: seen once",
                        "off --switch--> ?: once, and the device did not say where that led",
                        "open: on --switch--> dim: also led elsewhere");
        assertThat(ModelReference.parse(model.toString()).load().transitions())
                .extracting(Object::toString)
                .containsExactlyInAnyOrder("off --switch--> on", "on --switch--> off", "on --burnOut--> off");
    }

    @Test
    void toADeclaredModelOnlyWhatItLacksIsAdded() throws IOException {
        Path drawn = folder.resolve("drawn.mmd");
        Files.writeString(drawn, """
                stateDiagram-v2
                    [*] --> off
                    off --> on : switch
                    on --> off : switch
                    on --> dim : other
                """);

        assertThat(learn("--output=" + model, "--from=" + drawn)).isEqualTo(1);

        assertThat(out.toString())
                .contains("added: on --burnOut--> off: seen once")
                .doesNotContain("added: off --switch--> on");
        assertThat(ModelReference.parse(model.toString()).load().transitions())
                .extracting(Object::toString)
                .contains("off --switch--> on", "on --other--> dim", "on --burnOut--> off");
    }

    @Test
    void wrongInputIsNamed() {
        assertThat(learn("--output=" + model, "lamp.yaml")).isEqualTo(2);
        assertThat(err.toString()).contains("lamp.yaml");
    }
}
