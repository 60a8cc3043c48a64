package org.evoloop.xmi.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.xmi.text.TextDiagrams.file;
import static org.evoloop.xmi.text.TextDiagrams.refusal;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What cannot be understood is refused in one line, with file, line, column and the way to go on. */
class TextRefusalTest {
    private static void assertRefused(String name, String text, String... words) {
        assertThat(refusal(name, text)).startsWith(name + ": ").contains(words).doesNotContain("\n");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "power-off --> B | column 6: Mermaid allows no '-' in an id; write power_off, and state \"power-off\"",
                "A --> power-off-now | column 12: Mermaid allows no '-' in an id; write power_off_now",
                "state my-state | column 9: Mermaid allows no '-' in an id",
                "A -> B | column 3: Mermaid's arrow is -->",
                "A --> B : a; b | column 12: ';' ends a statement in Mermaid",
                "A --> B; | column 8: ';' would be a part of the id in Mermaid",
                "A : entry / a; b | column 14: ';' ends a statement",
                "A --> B[H] | column 8: Mermaid has no history",
                "[H] --> B | column 1: Mermaid has no history",
                "state h <<history>> | column 9: <<history>> is not known to Mermaid",
                "state \"x\" as f <<fork>> | column 16: Mermaid allows no name before a kind",
                "state \"x\" | column 10: a name in quotation marks needs an id",
                "state \"x as y | column 7: the quotation mark is not closed",
                "state A { | column 9: state 'A' is not closed",
                "} | column 1: } closes no state",
                "A --> B go | column 9: 'go' behind the transition is not understood; write a label behind a colon",
                "A --> | column 6: the id of a state is missing",
                "A[Long name] --> B | column 2: '[' would be a part of the id",
                "A --> B : go [x | column 14: '[' belongs to no guard",
                "A --> B : go x] / f | column 15: ']' has no '[' before it",
                "A --> B : [x] go / f | column 11: '[' belongs to no guard",
                "A : «device On | column 5: a keyword ends with » or >>",
                "A : <<device On>> for air | column 5: a keyword ends with » or >> and has nothing beside it",
                "A : / f | column 5: an internal transition needs an event",
                "-- | column 1: Mermaid has regions in states only",
                "state A { A --> B } | 'A' is named inside itself",
                "note left of A | column 1: the note has no end",
                "participant Bob | column 13: 'Bob' is no arrow",
            })
    void mermaid(String line, String problem) {
        assertRefused("lamp.mmd", "stateDiagram-v2\n[*] --> Off\n" + line + "\n", "line 3: ", problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "A.B --> C | column 2: PlantUML reads '.' in an id as a state inside 'A'",
                "A o-> B | column 3: 'o-> B' is no arrow",
                "state A {\\nstate A\\n} | 'A' is declared inside itself, where PlantUML draws another state",
                "A --> B:go | column 8: PlantUML takes ':go' for a part of the id; write a blank before the colon",
                "A --> B:at:noon sharp | column 8: PlantUML takes ':at:noon' for a part of the id",
                "A:go --> B | column 2: PlantUML takes ':go' for a part of the id",
                "!define X y | column 1: '!define X y' is for PlantUML's preprocessor, which is not run here",
                "A -- B | column 3: '-- B' is no arrow",
                "!include other.puml | column 1: '!include other.puml' is for PlantUML's preprocessor",
                "state x <<inputPin>> | column 9: <<inputPin>> has no meaning",
                "A --> B : [[http://x text]] | column 11: a link hides the text",
                "A --> B[H] | column 8: state 'B' has no region, and a history belongs to one",
                "state c <<choice>>\\nc : entry / f | 'c' is a choice, in which nothing happens",
                "/' comment | column 1: the comment /' has no end",
                "skinparam state { | column 1: skinparam has no end",
                "newpage | column 1: newpage begins another diagram; write each between its own @startuml and @enduml",
            })
    void plantUml(String line, String problem) {
        assertRefused(
                "lamp.puml", "@startuml\n[*] --> Off\n" + line.replace("\\n", "\n") + "\n@enduml\n", "line ", problem);
    }

    @Test
    void aRefusedStateIsClosedAllTheSame() {
        String text = "stateDiagram-v2\nstate A what {\n[*] --> B\nstate C % {\n[*] --> D\n}\n}\n[*] --> A\n";
        assertThat(refusal("F.mmd", text))
                .contains("line 2: column 9:", "line 4: column 9:")
                .doesNotContain("closes no state");
    }

    @Test
    void anIdInTwoCompositesIsRefused() {
        String composites = "state S {\nA --> B\n}\nstate T {\nA --> C\n}\n";

        assertRefused(
                "F.mmd",
                "stateDiagram-v2\n" + composites,
                "line 3: column 1: 'A' is named in S here, and in T in line 6");
        assertRefused(
                "F.puml",
                "@startuml\n" + composites + "@enduml\n",
                "line 6: column 1: 'A' is named in T here, and in S in line 3");
        assertRefused(
                "F.mmd",
                "stateDiagram-v2\nstate S {\nA --> B\n--\nC --> B : e\n}\n",
                "'B' is named in region 1 of S here, and in region 2 of S in line 5");
        assertRefused(
                "F.puml",
                "@startuml\nstate S {\nstate A\n--\nB --> C\n}\nstate T {\nD --> A\n}\n@enduml\n",
                "line 8: column 7: 'A' is named in T here, and in region 1 of S in line 3");
    }

    @Test
    void aPlaceThatVersionsOfPlantUmlUnderstandDifferentlyIsRefused() {
        assertRefused(
                "F.puml",
                "@startuml\nstate S {\nA --> B\n}\nB : waits\n@enduml\n",
                "line 5: column 1: 'B' is described in the diagram itself here, and belongs to S by line 3");
    }

    @Test
    void theContentsOfAStateAreInOnePlace() {
        assertRefused(
                "F.mmd",
                "stateDiagram-v2\nstate S {\nA --> B\n}\nstate S {\nC --> D\n}\n",
                "line 5: column 9: state 'S' has its contents in line 2 already");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "a.mmd | sequenceDiagram\\nA->>B: x | is a sequence diagram (line 1), not a state diagram",
                "a.xml | flowchart LR\\nA-->B | is a flowchart (line 1), not a state diagram",
                "a.mmd | graph TD\\nA-->B | is a flowchart (line 1)",
                "a.mmd | %% x\\nclassDiagram\\n | is a class diagram (line 2)",
                "a.mmd | hello | is no Mermaid diagram that is known (line 1)",
                "a.mmd | ---\\ntitle: x\\n | its title is not closed (line 1): write ---",
                "a.mmd | '' | is empty",
                "a.puml | @startuml\\nAlice -> Bob : hi\\n@enduml | is a sequence diagram (line 1)",
                "a.puml | @startuml\\nclass A\\n@enduml | is a class diagram (line 1)",
                "a.puml | @startuml\\nstart\\n:x;\\nstop\\n@enduml | is an activity diagram (line 1)",
                "a.puml | @startmindmap\\n* a\\n@endmindmap | is a PlantUML diagram of kind mindmap (line 1)",
                "a.puml | @startuml\\n[*] --> A | its diagram is not closed (line 1): write @enduml",
                "a.md | # T\\n```\\nstateDiagram-v2\\nA --> B\\n``` | a diagram in a block without a language (line 2); write ```mermaid",
                "a.md | ~~~\\n@startuml\\n[*] --> A\\n@enduml\\n~~~ | without a language (line 1); write ~~~plantuml",
                "a.md | # Only text | holds no state diagram: write one in a block ```mermaid",
                "a.md | ```mermaid\\nflowchart LR\\n``` | holds no state diagram, but a flowchart (line 2)",
                "a.md | ```mermaid\\nstateDiagram-v2\\n | its block is not closed (line 1): write ``` behind",
                "a.mmd | stateDiagram-v2 A --> B | 'A --> B' is behind stateDiagram-v2 (line 1): write it in the next line",
                "a.mmd | stateDiagram-v2 | (line 1) has a problem: line 1: the diagram has no state",
            })
    void whatIsNoStateDiagramIsCalledByItsName(String name, String text, String problem) {
        assertRefused(name, text.replace("\\n", "\n"), problem);
    }

    @Test
    void twoMachinesWithOneTitleAreToldApartByTheirLines() {
        String block = "```mermaid\nstateDiagram-v2\n[*] --> A\n```\n";
        ModelFile file = file("a.md", "# new\n" + block + block);

        assertThatThrownBy(() -> file.pick("new"))
                .isInstanceOf(ModelException.class)
                .hasMessageContainingAll("'new' names 2 state machines", "id L3", "id L7");
        assertThat(file.pick("L7").initial()).hasToString("A");
        assertThatThrownBy(() -> file.pick("The-New"))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith("a.md: no state machine is named 'The-New'; there is 'new'");
        assertThatThrownBy(() -> file.pick("nwe"))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith("a.md: no state machine is named 'nwe'; did you mean new? There is 'new'");
    }

    @Test
    void bytesThatAreNoTextAreRefused() {
        byte[] bytes = "stateDiagram-v2\n[*] --> \u00e4".getBytes(StandardCharsets.ISO_8859_1);

        assertThatThrownBy(() -> ModelFile.read("a.mmd", new ByteArrayInputStream(bytes)))
                .isInstanceOf(ModelException.class)
                .hasMessage("a.mmd: contains bytes that are not UTF-8 (line 2): save it in UTF-8");
    }

    @Test
    void aTextOf50MegabytesIsRefused() {
        assertRefused("a.mmd", "stateDiagram-v2\n" + "A --> B : e\n".repeat(4_300_000), "is larger than 16 MiB");
    }

    @Test
    void aTextOfTooManyOrTooDeepStatesIsRefused() {
        StringBuilder many = new StringBuilder("stateDiagram-v2\n");
        for (int i = 0; i < 600_000; i++) {
            many.append('s').append(i).append('\n');
        }
        StringBuilder deep = new StringBuilder("stateDiagram-v2\n");
        for (int i = 0; i < 400; i++) {
            deep.append("state s").append(i).append(" {\n");
        }

        assertRefused("a.mmd", many.toString(), "has more than 500000 states and transitions (line 500002)");
        assertRefused("a.mmd", deep.toString(), "nests states deeper than 300 (line 302)");
    }

    @Test
    void severalProblemsHaveALineEach() {
        assertThat(refusal("a.mmd", "stateDiagram-v2\nA -> B\nC -> D\n").lines())
                .hasSize(3)
                .anyMatch(line -> line.startsWith("  line 2: column 3: "));
    }
}
