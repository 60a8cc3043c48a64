package org.evoloop.xmi.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.text.TextDiagrams.file;
import static org.evoloop.xmi.text.TextDiagrams.mermaid;
import static org.evoloop.xmi.text.TextDiagrams.plantUml;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the statements of Mermaid and PlantUML mean. */
class TextReadingTest {
    private static final String START = "[*] of /1 -> A";

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "A --> B : go | go",
                "A-->B: go | go",
                "A-->B:go now | go now",
                "A --> B : go, come [x > 1] / f(a, b), g | go, come [x > 1] / f(a, b); g",
                "A --> B : go<br>[x]<br/>/ f | go [x] / f",
                "A --> B : go\\n/ f | go / f",
                "A --> B : go <br/> on<br>/ f | go on / f",
                "A --> B : denied (timeout / user) / f | denied (timeout / user) / f",
                "A --> B : \"x / y\" / f(\"/\") | \"x / y\" / f(\"/\")",
                "A --> B : after 2 s | after 2 s",
                "A --> B : tm(500ms) / f | tm(500ms) / f",
                "A --> B : user pressed the button | user pressed the button",
                "A --> B : [else] | [else]",
                "A --> B : go [true] | go",
                "A --> B : go [a[1] / 2 > b] / f | go [a[1] / 2 > b] / f",
                "A --> B : / f | / f",
                "A --> B : and\\/or \\[x\\] | and/or [x]",
                "A --> B : go {local} | go LOCAL",
                "A --> B : go / f «local» | go / f LOCAL",
                "A --> B : say(\"a, b\"), hush | say(\"a, b\"), hush",
                "A --> B : «spontaneous» done | done",
                "A --> B : <<spontaneous>> done | done",
                "A --> B : «urgent, spontaneous» done | done",
            })
    void labelsAreTheSameInBothLanguages(String transition, String label) {
        String expected = "A -> B : " + label;
        assertThat(mermaid("[*] --> A", transition)).contains(START, expected);
        assertThat(plantUml("[*] --> A", transition)).contains(START, expected);
    }

    @Test
    void aCommentAtTheEndOfALineIsIgnoredInPlantUml() {
        assertThat(plantUml("[*] --> A /' first '/", "A --> B : go /' and '/")).contains(START, "A -> B : go");
    }

    @Test
    void theKeywordsDeclareSpontaneousAndUrgentEvents() {
        StateMachine machine = file(
                        "lamp.mmd",
                        "stateDiagram-v2\n[*] --> A\nA --> B : «spontaneous» done, «urgent» fire, <<urgent, spontaneous>> low\n")
                .only();

        assertThat(machine.spontaneous()).extracting(Object::toString).containsExactly("done", "low");
        assertThat(machine.urgent()).extracting(Object::toString).containsExactly("fire", "low");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "state \"«device On» «sends stop, go» Warm\" as Warm",
                "Warm : «device On» «sends stop, go»",
                "Warm : <<device On>>\nWarm : <<sends stop, go>>",
                "state Warm <<device On>> <<sends stop, go>>",
            })
    void keywordsSayWhatAStateHasToDoWithTheDevice(String line) {
        for (String text : List.of(
                "stateDiagram-v2\n[*] --> Warm\n" + line + "\n", "@startuml\n[*] --> Warm\n" + line + "\n@enduml\n")) {
            StateMachine machine = file("F", text).only();

            assertThat(machine.deviceState(machine.initial())).isEqualTo("On");
            assertThat(machine.sends(machine.initial()))
                    .extracting(Object::toString)
                    .containsExactlyInAnyOrder("stop", "go");
        }
    }

    @Test
    void aMermaidEntityIsItsLetter() {
        assertThat(mermaid(
                        "state \"say #quot;hi#quot;\" as A", "[*] --> A", "A --> B : a#44; b#59; #91;c#93; / d #35;1"))
                .contains("state A say \"hi\"", "A -> B : a, b; [c] / d #1");
    }

    @Test
    void aPlantUmlEscapeIsItsLetter() {
        assertThat(plantUml("state \"say <U+0022>hi<U+0022>\" as A", "[*] --> A", "A --> B : a<U+002C> b&#59; c"))
                .contains("state A say \"hi\"", "A -> B : a, b; c");
    }

    @Test
    void textInAStateIsBehavior() {
        List<String> chart = mermaid(
                "[*] --> A",
                "A : entry / on, glow",
                "A : exit / off",
                "A : do / hum",
                "A : defer / later",
                "A : never / defer",
                "A : tick [x] / count",
                "A : swallowed /",
                "A : waits for somebody");

        assertThat(chart)
                .contains(
                        "state A A entry[on, glow] exit[off] do[hum] defer[later, never]",
                        "  A -> A : tick [x] / count INTERNAL",
                        "  A -> A : swallowed INTERNAL");
    }

    @Test
    void linesBelowANameAreBehaviorToo() {
        assertThat(mermaid(
                        "[*] --> A", "state \"Long<br>name<br/>entry / on<br>tick / count\" as A {", "[*] --> B", "}"))
                .contains("state A Long name entry[on]", "  A -> A : tick / count INTERNAL");
    }

    @Test
    void descriptionsAndLabelsOfTheStartAreNoted() {
        XmiMachine machine = file("F.mmd", "stateDiagram-v2\n[*] --> A : power on\nA : idle\nA : device On\n")
                .findOnly();

        assertThat(machine.notes())
                .hasSize(3)
                .anyMatch(note -> note.endsWith("'device On' describes state 'A' and does nothing; write «device On»"))
                .anyMatch(note -> note.startsWith("F.mmd: line 2: 'power on' at the start"))
                .anyMatch(note -> note.startsWith("F.mmd: line 3: column 5: 'idle' describes state 'A'"));
    }

    @Test
    void compositesRegionsAndPseudostates() {
        String[] lines = {
            "[*] --> A",
            "state \"Big one\" as big {",
            "  [*] --> B",
            "  B --> [*] : stop",
            "  --",
            "  [*] --> C",
            "}",
            "state f <<fork>>",
            "state j <<join>>",
            "state c <<choice>>",
            "A --> f : both",
            "f --> B",
            "f --> C",
            "B --> j",
            "C --> j",
            "j --> c",
            "c --> A : hot",
            "c --> big : [else]",
        };
        List<String> expected = List.of(
                "state A A",
                "state big Big one",
                "  state B B",
                "  INITIAL [*] of big/1",
                "  FINAL [*] ends big/1",
                "  state C C",
                "  INITIAL [*] of big/2",
                "FORK f",
                "JOIN j",
                "CHOICE c",
                "INITIAL [*] of /1",
                "[*] of /1 -> A",
                "[*] of big/1 -> B",
                "B -> [*] ends big/1 : stop",
                "[*] of big/2 -> C",
                "A -> f : both",
                "f -> B",
                "f -> C",
                "B -> j",
                "C -> j",
                "j -> c",
                "c -> A : [hot]",
                "c -> big : [else]");

        assertThat(mermaid(lines)).isEqualTo(expected);
        assertThat(plantUml(lines)).isEqualTo(expected);
    }

    @Test
    void aCompositeMayBeWrittenInOneLine() {
        assertThat(mermaid("state A { [*] --> B }", "[*] --> A")).contains("  state B B", START);
    }

    @Test
    void severalGuardsMustAllHold() {
        StateMachine machine = file("F.mmd", "stateDiagram-v2\n[*] --> A\nA --> B : e [x] [y] / f\n")
                .only();

        assertThat(machine.transitions()).hasToString("[A --e [x] [y]--> B]");
    }

    @Test
    void plantUmlHasHistoriesPointsAndOtherArrows() {
        List<String> chart = plantUml(
                "[*] -> A",
                "state S {",
                "  state in <<entryPoint>>",
                "  state out <<exitPoint>>",
                "  in --> X",
                "  X -up-> [H] : a",
                "  [H] --> X",
                "}",
                "A -[#red,dashed]-> S[H*] : b",
                "A <-- S : c",
                "A -[hidden]-> S",
                "A --> in : d",
                "state end <<end>>",
                "S --> end : e");

        assertThat(chart)
                .contains(
                        "  ENTRY_POINT in in",
                        "  EXIT_POINT out out",
                        "  SHALLOW_HISTORY [H] of S/1",
                        "  DEEP_HISTORY [H*] of S/1",
                        "FINAL end",
                        "X -> [H] of S/1 : a",
                        "[H] of S/1 -> X",
                        "A -> [H*] of S/1 : b",
                        "S -> A : c",
                        "A -> in : d",
                        "S -> end : e")
                .filteredOn(line -> line.startsWith("A -> S"))
                .isEmpty();
    }

    @Test
    void whatSaysNothingAboutBehaviorIsIgnored() {
        assertThat(mermaid(
                        "%% a comment",
                        "%%{init: {",
                        " 'theme': 'dark' } }%%",
                        "direction LR",
                        "[*] --> A:::hot",
                        "note right of A : x --> y",
                        "note left of A",
                        "  A --> Nowhere",
                        "end note",
                        "classDef hot fill:#f00,color:white",
                        "class A hot",
                        "style A fill:#fff",
                        "accTitle: title --> B",
                        "hide empty description",
                        "A --> A : again"))
                .containsExactly("state A A", "INITIAL [*] of /1", START, "A -> A : again");
        assertThat(plantUml(
                        "' a comment",
                        "/' A --> X",
                        "   A --> Y '/",
                        "!theme plain",
                        "title A --> Z",
                        "skinparam state {",
                        "  BackgroundColor red",
                        "}",
                        "<style>",
                        " a { b }",
                        "</style>",
                        "left to right direction",
                        "[*] --> A",
                        "state A #pink",
                        "note on link",
                        "  A --> Nowhere",
                        "end note",
                        "note \"x\" as N",
                        "N .. A",
                        "A --> A : again"))
                .containsExactly("state A A", "INITIAL [*] of /1", START, "A -> A : again");
    }

    @Test
    void whatPlantUmlPlacesOrContinuesIsNoTransition() {
        assertThat(plantUml(
                        "Title A lamp",
                        "legend right",
                        "A --> C : fake",
                        "endlegend",
                        "center footer",
                        "A --> C : fake",
                        "end footer",
                        "note right of A #back:yellow",
                        "A --> C : fake",
                        "endnote",
                        "note left of A : text",
                        "[*] --> A",
                        "A --> B : go \\",
                        "home"))
                .containsExactlyInAnyOrderElementsOf(plantUml("[*] --> A", "A --> B : go home"));
    }

    @Test
    void aStateMayBeCalledLikeAKeyword() {
        assertThat(mermaid("[*] --> note", "note --> style : direction", "style --> state"))
                .contains("note -> style : direction", "style -> state");
    }

    @Test
    void anIdBelongsWhereItsLanguageDrawsIt() {
        assertThat(mermaid("A --> X", "state S {", "X --> Y", "}")).contains("  state X X");
        assertThat(plantUml("A --> X", "state S {", "X --> Y", "}")).contains("state X X", "  state Y Y");
        assertThat(plantUml("A --> X", "state S {", "state X", "}")).contains("  state X X");
        assertThat(plantUml("state S {", "A --> X", "}", "state X {", "Y --> Z", "}"))
                .contains("  state A A", "state X X", "  state Y Y");
    }

    @Test
    void inPlantUmlAnArrowMayLeadToAStateThatAnotherOneDeclares() {
        assertThat(plantUml("state S {", "state X", "}", "state T {", "A --> X : go", "}"))
                .contains("state S S", "  state X X", "state T T", "  state A A", "A -> X : go");
    }

    @Test
    void aHistoryMayBeNamedBeforeItsState() {
        assertThat(plantUml("[*] --> A", "A --> S[H] : go", "state S {", "[*] --> X", "}"))
                .contains("  SHALLOW_HISTORY [H] of S/1", "A -> [H] of S/1 : go");
    }

    @Test
    void commentsAndEndsOfArrowsAreTakenOut() {
        assertThat(plantUml("[*] --> A /' here '/", "/' there '/ A x->o B : go", "o --> x", "B <-x A : back"))
                .contains(START, "A -> B : go", "o -> x", "A -> B : back");
    }

    @Test
    void proseThatCouldMeanSomethingElseIsNoted() {
        XmiMachine machine = file("F.mmd", """
                        stateDiagram-v2
                        [*] --> A
                        A --> B : POST /users
                        B --> A : ready, the lock is held
                        A --> B : go [x]/f
                        A --> B : key, other / f
                        B --> A : after 2 s, key
                        B : read/write
                        """).findOnly();

        assertThat(machine.notes())
                .containsExactly(
                        "F.mmd: line 3: column 16: 'users' behind '/' is what is done; write blanks around the '/' if it is,"
                                + " or \\/ for the letter",
                        "F.mmd: line 4: 'ready, the lock is held' names 2 events; write \\, for a comma in the name of one",
                        "F.mmd: line 8: column 9: 'write' behind '/' is what is done; write blanks around the '/' if it is,"
                                + " or \\/ for the letter");
    }

    @Test
    void aMarkdownFileHoldsAMachineInEachBlock() {
        ModelFile file = file(
                "README.md",
                "# Lamp\n\n## The `original`\n\n```mermaid\nstateDiagram-v2\n[*] --> A\n```\n\n```mermaid\n---\n"
                        + "title: \"new\"\n---\nstateDiagram\n[*] --> B\n```\n\n~~~plantuml\ntitle third\n[*] --> C\n~~~\n\n"
                        + "```mermaid\nflowchart LR\nA --> B\n```\n```sh\n# no heading\n```\n");

        assertThat(file.references()).containsExactly("README.md#The original", "README.md#new", "README.md#third");
        assertThat(file.find("new").line()).isEqualTo(14);
        assertThat(file.find("L14").name()).isEqualTo("new");
        assertThat(file.pick("third").initial()).hasToString("C");
    }

    @Test
    void anUnderlinedLineIsAHeading() {
        String block = "```mermaid\nstateDiagram-v2\n[*] --> A\n```\n";

        assertThat(file(
                                "F.md",
                                "---\nlayout: page\n---\n" + block + "\n---\nold *one*\n===\n" + block + "new\n---\n"
                                        + block)
                        .machines())
                .extracting(XmiMachine::name)
                .containsExactly("L5", "old one", "new");
    }

    @Test
    void aMachineIsCalledByItsTitleOrElseItsFile() {
        assertThat(file("a/lamp.mmd", "stateDiagram-v2\n[*] --> A\n").findOnly().name())
                .isEqualTo("lamp");
        assertThat(file("lamp.puml", "@startuml new\n[*] --> A\n@enduml\n@startuml\ntitle old\n[*] --> A\n@enduml\n")
                        .machines())
                .extracting(XmiMachine::name)
                .containsExactly("new", "old");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\ufeffstateDiagram-v2\n[*] --> A\n",
                "stateDiagram-v2\r\n[*] --> A\r\n",
                "stateDiagram-v2\n\t[*]\t-->\tA\t\n",
                "\n\n  stateDiagram-v2\n\u00a0[*] --> A",
                "%% lamp\n%%{init: {}}%%\nstateDiagram\n[*] --> A\n",
            })
    void theBeginningTellsTheLanguageWhateverTheFileIsCalled(String text) {
        assertThat(file("model.txt", text).only().initial()).hasToString("A");
    }

    @Test
    void aTextOfTwoBytesALetterIsRead() {
        byte[] bytes = "stateDiagram-v2\n[*] --> 点灯\n".getBytes(StandardCharsets.UTF_16);

        assertThat(ModelFile.read("lamp.mmd", new java.io.ByteArrayInputStream(bytes))
                        .only()
                        .initial())
                .hasToString("点灯");
    }
}
