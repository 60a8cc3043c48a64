package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.PaperModels;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A lamp whose models are replaced from its console. */
class EvolveCommandsTest {
    @TempDir
    private Path directory;

    private final LampConverter lamp =
            new LampConverter(LoopConfig.defaults("lamp", new ManualClock()).withoutThreads());
    private final Captured out = new Captured();
    private final Captured err = new Captured();

    private void run(String... lines) {
        run(EvolveCommandsTest::read, lines);
    }

    private void run(NewModels models, String... lines) {
        InputStream in =
                new ByteArrayInputStream(String.join("\n", lines).concat("\n").getBytes(StandardCharsets.UTF_8));
        Console console = new Console(lamp.converter, in, out.stream, err.stream);
        console.evolvesBy(models);
        console.run();
    }

    private static StateMachine read(String reference) {
        if (!reference.equals("lamp.xml#plain")) {
            throw new ModelException("lamp.xml has no machine '" + reference + "'");
        }
        return PaperModels.lightBulb().original().withName("plain");
    }

    private static StateMachine readAny(String reference) {
        return switch (reference) {
            case "lamp.xml#original" -> PaperModels.lightBulb().original();
            case "lamp.xml#new" -> PaperModels.lightBulb().evolved();
            case "lamp.xml#other" -> PaperModels.cleaningRobot().original();
            default -> read(reference);
        };
    }

    @Test
    void theListOfCommandsHasAWholeSentenceForEach() {
        run("help");
        assertThat(String.join(" ", out.lines()).replaceAll(" +", " "))
                .contains("two events rollback", "without acting on its decisions promote makes");
    }

    @Test
    void whatFitsTheDeviceIsOfferedAndChosen() {
        Console console = new Console(lamp.converter, InputStream.nullInputStream(), out.stream, err.stream);
        console.evolvesBy(NewModels.offering(
                List.of("lamp.xml#original", "lamp.xml#new", "lamp.xml#plain", "lamp.xml#other", "lamp.xml#gone"),
                EvolveCommandsTest::readAny));
        OfferedModels offered = console.offeredModels().orElseThrow();
        assertThat(offered.references()).containsExactly("lamp.xml#new", "lamp.xml#plain");
        assertThat(offered.running()).contains("lamp.xml#new");
        lamp.converter.start();
        offered.choose("lamp.xml#plain");
        assertThat(offered.running()).contains("lamp.xml#plain");
        assertThat(lamp.converter.knowledge().models().evolved().name()).isEqualTo("plain");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> offered.choose("lamp.xml#other"))
                .withMessageContaining("lamp.xml#other");
    }

    @Test
    void aRollbackHasADeadline() {
        run("start", "evolve lamp.xml#plain", "rollback --within 5");
        assertThat(err.text()).isEmpty();
        assertThat(out.text()).endsWith("evolved to 'new': (off, off) is (off, off)\n");
    }

    @Test
    void otherModelsTakeOverAndAreTakenBack() {
        run("start", "evolve lamp.xml#plain", "status", "rollback", "status");
        assertThat(err.text()).isEmpty();
        assertThat(out.text()).isEqualTo("""
                running: original off, new off
                evolved to 'plain': (off, off) is (off, off)
                converter   lamp, running
                states      original off, new off
                models      'plain', which took over from 'new'
                now         waiting for an event
                evolved to 'new': (off, off) is (off, off)
                converter   lamp, running
                states      original off, new off
                now         waiting for an event
                """);
    }

    @Test
    void aLineBreakInTheNameOfAModelBeginsNoLine() {
        lamp.converter.start();
        run(reference -> read("lamp.xml#plain").withName("plain\nforged"), "evolve any", "shadow any");
        assertThat(err.text()).isEmpty();
        assertThat(out.lines())
                .containsExactly(
                        "evolved to 'plain?forged': (off, off) is (off, off)",
                        "shadow of 'plain?forged': 0 events, 0 of them decided differently");
    }

    @Test
    void aShadowGetsTheSameInputsAndIsPromoted() {
        run(
                "start",
                "shadow",
                "promote",
                "shadow lamp.xml#plain --probation-events 3",
                "status",
                "shadow",
                "shadow off",
                "shadow lamp.xml#plain --probation-events 3",
                "promote",
                "shadow");
        assertThat(err.lines()).containsExactly("error: no shadow; shadow FILE#NAME begins one");
        assertThat(out.text()).isEqualTo("""
                running: original off, new off
                no shadow; shadow FILE#NAME begins one
                shadow of 'plain': 0 events, 0 of them decided differently
                converter   lamp, running
                states      original off, new off
                shadow      'plain': 0 events, 0 of them decided differently
                now         waiting for an event
                'plain': 0 events, 0 of them decided differently; it would be in (off, off)
                ended 'plain': 0 events, 0 of them decided differently
                shadow of 'plain': 0 events, 0 of them decided differently
                evolved to 'plain': (off, off) is (off, off)
                on probation: rolls back by itself if anything goes wrong
                no shadow; shadow FILE#NAME begins one
                """);
    }

    @Test
    void probationIsShownAndAnOptionNeedsItsValue() {
        run(
                "start",
                "evolve lamp.xml#plain --probation 60 --probation-events 3",
                "status",
                "evolve lamp.xml#plain --within",
                "evolve lamp.xml#plain --within soon",
                "evolve lamp.xml#plain --when-idel 3",
                "evolve lamp.xml#plane",
                "rollback --soon",
                "rollback --within",
                "evolve");
        assertThat(out.text())
                .contains("on probation: rolls back by itself if anything goes wrong")
                .contains("models      'plain', which took over from 'new', on probation for 60 s or 3");
        assertThat(err.lines())
                .containsExactly(
                        "error: --within needs a value after it",
                        "error: --within takes a number from 0 to 86400, not 'soon'",
                        "error: evolve has no option --when-idel; did you mean --when-idle?",
                        "error: lamp.xml has no machine 'lamp.xml#plane'",
                        "error: rollback has no option --soon; it takes --within SECONDS",
                        "error: --within needs a value after it",
                        "error: usage: evolve FILE#NAME [OPTION...]");
    }

    @Test
    void aMappingThatIsWrongOrMissingIsNamed() throws Exception {
        Path mapping = Files.writeString(directory.resolve("m.txt"), "state glowing -> off\n");
        run("evolve lamp.xml#plain --mapping " + mapping, "evolve lamp.xml#plain --mapping none.txt");
        assertThat(err.lines())
                .containsExactly(
                        "error: " + mapping + ", line 1: 'glowing' is no state of the running new model; there are"
                                + " incandescentOn, off, on, wait",
                        "error: none.txt cannot be read (none.txt); name a file of mapping rules");
    }
}
