package org.evoloop.xmi.text;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.ModelFile;

/** Diagrams in texts. */
final class TextDiagrams {
    private TextDiagrams() {}

    static ModelFile file(String name, String text) {
        return ModelFile.read(name, new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    }

    /** The chart of a Mermaid diagram with these lines. */
    static List<String> mermaid(String... lines) {
        return ChartText.of(file("F.mmd", "stateDiagram-v2\n" + String.join("\n", lines) + "\n")
                .findOnly()
                .statechart());
    }

    /** The chart of a PlantUML diagram with these lines. */
    static List<String> plantUml(String... lines) {
        return ChartText.of(file("F.puml", "@startuml\n" + String.join("\n", lines) + "\n@enduml\n")
                .findOnly()
                .statechart());
    }

    /** Why the file or its only machine cannot be used; empty if it can. */
    static String refusal(String name, String text) {
        try {
            file(name, text).findOnly().statechart();
            return "";
        } catch (ModelException refused) {
            return String.valueOf(refused.getMessage());
        }
    }
}
