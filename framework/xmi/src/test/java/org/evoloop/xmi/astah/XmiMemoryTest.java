package org.evoloop.xmi.astah;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Documents of 1 GiB that must be read far into the file, each in its own virtual machine with a small heap. */
@Tag("slow")
class XmiMemoryTest {
    private static final String TOO_LARGE = "F.xml: its state machines are too large (line ";
    private static final String TOO_LONG = "F.xml: is larger than 1024 MiB (line ";

    private static final Map<String, Supplier<String>> ATTACKS = new LinkedHashMap<>();

    static {
        repeat("text", Attack.HEAD, index -> "text ");
        repeat("textInMachine", Attack.TRANSITIONS, index -> "text ");
        repeat("blanksInMachine", Attack.TRANSITIONS, index -> "     ");
        repeat("comments", "", index -> "<!-- a -->");
        repeat("elements", Attack.HEAD, index -> "<a b='c'>text</a>");
        repeat("transitions", Attack.TRANSITIONS, index -> "<UML:Transition/>");
        repeat("roles", Attack.TRANSITIONS + "<UML:Transition>", index -> "<UML:Transition.trigger/>");
        repeat("longNames", Attack.TRANSITIONS, index -> "<UML:Transition name='" + "x".repeat(99_999) + "'/>");
        repeat("unknownElements", Attack.TRANSITIONS, index -> "<UML:Unknown xmi.id='" + index + "'/>");
        repeat("unknownAttributes", Attack.TRANSITIONS, index -> "<UML:Transition unknown='" + index + "'/>");
        repeat("references", Attack.REFERENCES, index -> "<UML:StateMachine xmi.idref='" + index + "'/>");
        repeat("ids", Attack.REFERENCES, index -> "<UML:StateMachine xmi.id='" + index + "'/>");
        repeat("machines", Attack.HEAD, index -> "<UML:StateMachine/>");
        repeat("events", Attack.HEAD, index -> "<UML:Event xmi.id='" + index + "' name='e'/>");
        repeat(
                "diagrams",
                Attack.HEAD,
                index ->
                        "<JUDE:StateChartDiagram name='d'><JUDE:StateChartDiagram.semanticModel><UML:StateMachine xmi.idref='"
                                + index + "'/></JUDE:StateChartDiagram.semanticModel></JUDE:StateChartDiagram>");
        ATTACKS.put(
                "hundredThousandTransitions",
                () -> LargeMachine.read(100_000).transitions().size() + " transitions");
    }

    private static void repeat(String name, String beginning, LongFunction<String> units) {
        ATTACKS.put(name, () -> Attack.answer(beginning, units));
    }

    /** The small virtual machine. */
    public static void main(String[] arguments) {
        System.out.print(ATTACKS.get(arguments[0]).get());
    }

    @ParameterizedTest
    @CsvSource({
        "text, 64, " + TOO_LONG,
        "textInMachine, 64, " + TOO_LONG,
        "blanksInMachine, 64, " + TOO_LONG,
        "comments, 64, " + TOO_LONG,
        "elements, 64, " + TOO_LONG,
        "transitions, 400, " + TOO_LARGE,
        "roles, 400, " + TOO_LARGE,
        "longNames, 400, " + TOO_LARGE,
        "unknownElements, 400, " + TOO_LARGE,
        "unknownAttributes, 400, " + TOO_LARGE,
        "references, 400, " + TOO_LARGE,
        "ids, 400, " + TOO_LARGE,
        "machines, 400, " + TOO_LARGE,
        "events, 400, " + TOO_LARGE,
        "diagrams, 400, " + TOO_LARGE,
        "hundredThousandTransitions, 400, 100000 transitions"
    })
    void shouldStayWithinTheHeap(String attack, int heapMib, String answer) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Xmx" + heapMib + "m",
                        "-cp",
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                        XmiMemoryTest.class.getName(),
                        attack)
                .redirectErrorStream(true)
                .start();
        try {
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(output).startsWith(answer);
            assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
        } finally {
            process.destroyForcibly();
        }
    }
}
