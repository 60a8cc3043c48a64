package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Stream;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ModelEditor.Edited;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Edits of a machine as edits of its text. */
class ModelEditorTest {
    /** A text in which a machine is edited. */
    private record Sample(String file, String machine, String text) {
        Sample edited(Function<ModelEditor, Edited> edit) {
            return new Sample(file, machine, edit.apply(editor()).text());
        }

        ModelEditor editor() {
            return new ModelEditor(file, text, machine);
        }

        StateMachine read() {
            ModelFile read = ModelFile.read(file, new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
            return machine.isEmpty() ? read.only() : read.pick(machine);
        }

        /** The line of the only line with this text. */
        int line(String part) {
            List<String> lines = text.lines().toList();
            for (int i = 0; i < lines.size(); i++) {
                if (lines.get(i).contains(part)) {
                    return i + 1;
                }
            }
            throw new IllegalArgumentException("no line has " + part);
        }

        @Override
        public String toString() {
            return file;
        }
    }

    private static final String LAMP = """
                [*] --> off
                off --> on : switch

                on-->off:switch [dark] / beep
                note right of on : on is bright
            """;

    static Stream<Sample> samples() {
        String mermaid = "stateDiagram-v2\n" + LAMP;
        return Stream.of(
                new Sample("lamp.mmd", "", mermaid),
                new Sample(
                        "lamp.puml",
                        "",
                        "@startuml\n' a comment\n" + LAMP.replace("on-->off:switch", "on --> off : switch")
                                + "@enduml"),
                new Sample(
                        "README.md",
                        "second",
                        "# Lamp\n```mermaid\n---\ntitle: first\n---\n" + mermaid + "```\nand\r\n```mermaid\r\n---\r\n"
                                + "title: second\r\n---\r\n" + mermaid.replace("\n", "\r\n") + "```"),
                new Sample("lamp.scxml", "", """
                        <?xml version="1.0"?>
                        <!-- <state id="none"/> -->
                        <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" initial="off">
                          <state id="off">
                            <transition event="switch" target="on"/>
                          </state>
                          <state id='on'>
                            <transition event='switch'
                                cond="dark" target="off"/>
                          </state>
                        </scxml>
                        """));
    }

    private static List<String> transitions(StateMachine machine) {
        return machine.transitions().stream().map(Transition::toString).sorted().toList();
    }

    @ParameterizedTest
    @MethodSource("samples")
    void thirtyEditsMakeTheMachineThatTheyDescribe(Sample sample) {
        boolean xml = sample.file().endsWith("scxml");
        Sample now = sample;
        List<Function<ModelEditor, Edited>> edits = List.of(
                e -> e.addState("warm", ""),
                e -> e.addTransition("on", "warm", "switch", "cold"),
                e -> e.addTransition("warm", "off", "tm(2s)", ""),
                e -> e.addState("wait", ""),
                e -> e.addTransition("wait", "warm", "go", ""),
                e -> e.addTransition("warm", "wait", "stop", ""),
                e -> e.renameState("wait", "pause"),
                e -> e.addState("in1", "pause"),
                e -> e.addState("in2", "pause"),
                e -> e.addTransition("in1", "in2", "next", ""),
                e -> e.addTransition("in2", "off", "switch", ""),
                e -> e.setInitial("in2"),
                e -> e.setInitial("in1"),
                e -> e.setDeviceState("warm", "on"),
                e -> e.renameDeviceState("on", "bright"),
                e -> e.setDeviceState("warm", "dark"),
                e -> e.setDeviceState("warm", ""));
        int done = 0;
        for (Function<ModelEditor, Edited> edit : edits) {
            now = now.edited(edit);
            now.read();
            done++;
        }
        assertThat(now.read().states().stream().map(State::name))
                .containsExactlyInAnyOrder("off", "on", "warm", "in1", "in2");
        assertThat(transitions(now.read()))
                .contains("warm --tm(2s)--> off", "in1 --next--> in2", "in2 --switch--> off", "warm --stop--> in1");
        int next = now.line(xml ? "\"next\"" : ": next");
        now = now.edited(e -> e.setTrigger(next, "forth"));
        now = now.edited(e -> e.setGuard(next, "ready"));
        assertThat(transitions(now.read())).contains("in1 --forth [ready]--> in2");
        now = now.edited(e -> e.setGuard(next, "steady"));
        now = now.edited(e -> e.setGuard(next, ""));
        now = now.edited(e -> e.setTrigger(next, "next, forth"));
        assertThat(transitions(now.read())).contains("in1 --forth--> in2", "in1 --next--> in2");
        now = now.edited(e -> e.setTrigger(next, "next"));
        now = now.edited(e -> e.retarget(next, "", "in1"));
        assertThat(transitions(now.read())).contains("in1 --next--> in1");
        now = now.edited(e -> e.deleteTransition(next));
        assertThat(transitions(now.read())).doesNotContain("in1 --next--> in1");
        now = now.edited(e -> e.renameState("warm", "hot"));
        now = now.edited(e -> e.renameState("hot", "warm"));
        done += 10;
        now = now.edited(e -> e.deleteState("in2"));
        now = now.edited(e -> e.deleteState("pause"));
        now = now.edited(e -> e.deleteState("warm"));
        assertThat(done + 3).isEqualTo(30);
        // A namespace stays, since others may use it.
        assertThat(now.text().replace(" xmlns:ev=\"urn:evoloop\"", "")).isEqualTo(sample.text());
    }

    @ParameterizedTest
    @MethodSource("samples")
    void anEventBecomesTheDevicesOwnAndNoLonger(Sample sample) {
        Sample own = sample.edited(e -> e.addTransition("on", "off", "«spontaneous» burnt", ""));
        int line = own.line("burnt");
        assertThat(own.read().spontaneous()).containsExactly(new Event("burnt"));
        Sample both = own.edited(e -> e.setTrigger(line, "«urgent» burnt, «urgent» broken"));
        assertThat(both.read().spontaneous()).isEmpty();
        assertThat(both.read().urgent()).containsExactlyInAnyOrder(new Event("burnt"), new Event("broken"));
        Sample plain = both.edited(e -> e.setTrigger(line, "burnt"));
        assertThat(plain.read().urgent()).isEmpty();
        assertThat(transitions(plain.read())).contains("on --burnt--> off");
    }

    @ParameterizedTest
    @MethodSource("samples")
    void lineBreaksAndAByteOrderMarkStay(Sample sample) {
        String windows = "\uFEFF" + sample.text().replace("\r\n", "\n").replace("\n", "\r\n");
        String edited = new Sample(sample.file(), sample.machine(), windows)
                .edited(e -> e.addState("warm", ""))
                .edited(e -> e.addTransition("on", "warm", "heat", ""))
                .text();
        assertThat(edited).startsWith("\uFEFF").contains("heat");
        assertThat(edited.replace("\r\n", "")).doesNotContain("\n", "\r");
    }

    @Test
    void inScxmlAKeywordIsForAllEventsOfATransition() {
        Sample scxml = samples()
                .filter(each -> each.file().endsWith("scxml"))
                .findFirst()
                .orElseThrow();
        assertThatThrownBy(() -> scxml.editor().addTransition("on", "off", "«spontaneous» burnt, broken", ""))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("give each kind a transition of its own");
    }

    @ParameterizedTest
    @MethodSource("samples")
    void anEditAndItsInverseRestoreTheText(Sample sample) {
        assertThat(sample.edited(e -> e.addState("warm", ""))
                        .edited(e -> e.deleteState("warm"))
                        .text())
                .isEqualTo(sample.text());
        Edited added = sample.editor().addTransition("off", "on", "go", "g");
        assertThat(new ModelEditor(sample.file(), added.text(), sample.machine())
                        .deleteTransition(added.line())
                        .text())
                .isEqualTo(sample.text());
        assertThat(sample.edited(e -> e.renameState("on", "x"))
                        .edited(e -> e.renameState("x", "on"))
                        .text())
                .isEqualTo(sample.text());
        int dark = sample.line("dark");
        int last = sample.machine().isEmpty()
                ? dark
                : sample.text().substring(0, sample.text().lastIndexOf("dark")).split("\n", -1).length;
        assertThat(sample.edited(e -> e.setTrigger(last, "x"))
                        .edited(e -> e.setTrigger(last, "switch"))
                        .text())
                .isEqualTo(sample.text());
        assertThat(sample.edited(e -> e.setGuard(last, "x"))
                        .edited(e -> e.setGuard(last, "dark"))
                        .text())
                .isEqualTo(sample.text());
        assertThat(sample.edited(e -> e.retarget(last, "", "on"))
                        .edited(e -> e.retarget(last, "", "off"))
                        .text())
                .isEqualTo(sample.text());
        assertThat(sample.edited(e -> e.setInitial("on"))
                        .edited(e -> e.setInitial("off"))
                        .text())
                .isEqualTo(sample.text());
        assertThat(sample.edited(e -> e.setDeviceState("on", "off"))
                        .edited(e -> e.setDeviceState("on", ""))
                        .text()
                        .replace(" xmlns:ev=\"urn:evoloop\"", ""))
                .isEqualTo(sample.text());
    }

    @ParameterizedTest
    @MethodSource("samples")
    void anEditChangesOnlyItsOwnLines(Sample sample) {
        Edited edited = sample.editor().addState("warm", "");
        List<String> before = sample.text().lines().toList();
        List<String> after = new ArrayList<>(edited.text().lines().toList());
        assertThat(after.remove(edited.line() - 1)).contains("warm");
        assertThat(after).isEqualTo(before);
    }

    /** Whatever is edited in whatever order, the text can be read and has what was asked for, or the edit is refused. */
    @ParameterizedTest
    @MethodSource("samples")
    void randomEditsAreDoneOrRefused(Sample sample) {
        long seed = System.nanoTime();
        Random random = new Random(seed);
        Sample now = sample;
        int done = 0;
        for (int i = 0; i < 150; i++) {
            try {
                now = now.edited(edit(random, now.text().lines().toList().size()));
                done++;
            } catch (ModelException refused) {
                assertThat(refused.getMessage()).as("seed %s", seed).isNotBlank();
            }
            ModelFile read = ModelFile.read(
                    now.file(), new ByteArrayInputStream(now.text().getBytes(StandardCharsets.UTF_8)));
            (now.machine().isEmpty() ? read.findOnly() : read.find(now.machine())).statechart();
        }
        assertThat(done).as("seed %s", seed).isGreaterThan(20);
    }

    private static Function<ModelEditor, Edited> edit(Random random, int lines) {
        String one = "s" + random.nextInt(8);
        String other = random.nextInt(5) == 0 ? "on" : "s" + random.nextInt(8);
        String text = List.of("e", "e, f", "a/b", "x [y]", "«spontaneous» z", "{;}", "ü ß", "tm(2s)")
                .get(random.nextInt(8));
        int line = 1 + random.nextInt(lines);
        return switch (random.nextInt(12)) {
            case 0, 1 -> e -> e.addState(one, "");
            case 2 -> e -> e.addState(one, other);
            case 3, 4 -> e -> e.addTransition(one, other, text, "");
            case 5 -> e -> e.addTransition(other, one, "e", text);
            case 6 -> e -> e.renameState(one, other);
            case 7 -> e -> e.setTrigger(line, text);
            case 8 -> e -> e.setGuard(line, text);
            case 9 -> e -> e.retarget(line, one, other);
            case 10 -> e -> e.setDeviceState(one, "off");
            default -> random.nextBoolean() ? e -> e.deleteTransition(line) : e -> e.deleteState(one);
        };
    }

    @Test
    void namesThatAreNoIdsAreWrittenInQuotationMarks() {
        Sample lamp = samples()
                .findFirst()
                .orElseThrow()
                .edited(e -> e.addState("very \"warm\" light", ""))
                .edited(e -> e.addTransition("on", "very \"warm\" light", "a, b; c", ""))
                .edited(e -> e.renameState("off", "all dark"));
        assertThat(lamp.read().states()).contains(new State("very \"warm\" light"), new State("all dark"));
        assertThat(lamp.read().initial()).isEqualTo(new State("all dark"));
        assertThat(lamp.read().transitionsFrom(new State("on")))
                .extracting(Transition::event)
                .contains(new Event("a, b; c"));
    }

    @Test
    void aTransitionToTheContentsOfAnotherStateLeavesThemThere() {
        Sample nested = new Sample("n.mmd", "", """
                stateDiagram-v2
                    [*] --> A
                    state A {
                        [*] --> In
                        In --> In2 : e
                    }
                    state B {
                        [*] --> Out
                    }
                    In2 --> Out : f
                """);
        StateMachine crossed =
                nested.edited(e -> e.retarget(nested.line(": e"), "", "Out")).read();
        assertThat(transitions(crossed)).contains("In --e--> Out", "In2 --f--> Out");
        assertThat(transitions(nested.edited(e -> e.addTransition("Out", "In", "g", ""))
                        .read()))
                .contains("Out --g--> In");
    }

    @Test
    void whatCannotBeEditedIsRefusedWithTheReason() {
        Sample lamp = samples().findFirst().orElseThrow();
        assumeThat(lamp.file()).isEqualTo("lamp.mmd");
        assertThatThrownBy(() -> lamp.editor().addState("on", "")).hasMessageContaining("already");
        assertThatThrownBy(() -> lamp.editor().renameState("none", "x")).hasMessageContaining("no state named none");
        assertThatThrownBy(() -> lamp.editor().setTrigger(1, "x")).hasMessageContaining("line 1");
        assertThatThrownBy(() -> new ModelEditor("x.mmd", "stateDiagram-v2\n a -> b", "").addState("c", ""))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("line 2");
    }

    @Test
    void theFirstStateOfADiagramIsItsStart() {
        Edited first = new ModelEditor("x.mmd", "stateDiagram-v2\n", "").addState("Off", "");
        assertThat(first.text()).isEqualTo("stateDiagram-v2\n    [*] --> Off\n");
    }

    @Test
    void aNoteOfSeveralLinesGoesWithItsState() {
        for (String end : List.of("end note", "endnote")) {
            String text = "@startuml\n[*] --> off\noff --> on : switch\nnote right of on\n  on is bright\n" + end
                    + "\non --> off : switch\n@enduml\n";
            assertThat(new ModelEditor("lamp.puml", text, "").deleteState("on").text())
                    .isEqualTo("@startuml\n[*] --> off\n@enduml\n");
        }
        String mermaid =
                "stateDiagram-v2\n  [*] --> off\n  off --> on : a\n  note left of on\n   b\n  end note\n  note right of off : c\n";
        assertThat(new ModelEditor("lamp.mmd", mermaid, "").deleteState("on").text())
                .isEqualTo("stateDiagram-v2\n  [*] --> off\n  note right of off : c\n");
    }

    @Test
    void anEventIsPutApartFromTheGuardBehindIt() {
        String text = "stateDiagram-v2\n    [*] --> off\n    off --> on : [dark]\n";
        assertThat(new ModelEditor("lamp.mmd", text, "").setTrigger(3, "switch").text())
                .contains("off --> on : switch [dark]");
    }

    @Test
    void aStateOfScxmlGoesWithWhatLeadsIntoIt() {
        String text = """
                <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" initial="off">
                  <state id="off">
                    <transition event="resume" target="last"/>
                    <transition event="dim" target="dimmed"/>
                  </state>
                  <state id="on" initial="bright">
                    <history id="last"><transition target="bright"/></history>
                    <state id="bright"/>
                    <state id="dimmed"/>
                  </state>
                </scxml>
                """;
        ModelEditor editor = new ModelEditor("lamp.scxml", text, "");
        assertThat(editor.deleteState("on").text()).doesNotContain("target=");
        assertThatThrownBy(() -> new ModelEditor("lamp.scxml", text, "").deleteState("off"))
                .hasMessage("off is where it begins; let another state begin, and then delete it");
    }
}
