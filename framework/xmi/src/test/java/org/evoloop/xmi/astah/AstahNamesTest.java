package org.evoloop.xmi.astah;

import static org.assertj.core.api.Assertions.assertThat;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.integers;
import static org.quicktheories.generators.SourceDSL.lists;
import static org.quicktheories.generators.SourceDSL.longs;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AstahNamesTest {
    private static final String[] PIECES = {
        "On", "tm(2s)", " ", "%", "+", "%2", "&", "<b>", "\"", "'", "#", "/", "開始", "状態0", "é", "\uD83E\uDD16", "_", "0"
    };

    @ParameterizedTest
    @CsvSource(
            ignoreLeadingAndTrailingWhitespace = false,
            value = {
                "On,On",
                "tm%282s%29,tm(2s)",
                "a+b,a b",
                "1%2B1,1+1",
                "%E9%96%8B%E5%A7%8B%E7%96%91%E4%BC%BC%E7%8A%B6%E6%85%8B0,開始疑似状態0",
                "+On%0A,On",
                "line%0D%0A+trace%0Ain+two,line trace in two",
                "%E3%80%80wide%E3%80%80,wide",
                "100%,100%",
                "%zz+b,%zz+b",
                "%0A,''",
            })
    void shouldDecodeANameAsAstahWroteIt(String written, String drawn) {
        assertThat(AstahNames.decode(written)).isEqualTo(drawn);
    }

    @Test
    void shouldNotDecodeTheNameOfADiagram() {
        String document = new AstahDocument()
                .add(AstahDocument.offOn("m"))
                .diagram("  100% a+b %41\n", "m")
                .text();

        assertThat(read(document).get(0).name()).isEqualTo("100% a+b %41");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "t", "x", "-1", "99999999999"})
    void shouldNotCareWhatAttributesWithoutMeaningSay(String value) {
        String document = new AstahDocument()
                .add(AstahDocument.offOn("m"))
                .text()
                .replaceAll("(version|unSolvedFlag|isConcurrent|isRegion)=\"(0|true|false)\"", "$1=\"" + value + "\"");

        assertThat(read(document).get(0).toStateMachine().states()).hasSize(2);
    }

    /** On a failure, the property library prints the seed, and the assertion's message the machine. */
    @Test
    void shouldReadBackEveryMachineThatAstahCouldWrite() {
        qt().withGenerateAttempts(10_000)
                .withExamples(300)
                .forAll(lists().of(names()).ofSizeBetween(1, 12), longs().all())
                .checkAssert((names, seed) -> {
                    List<String> states = List.copyOf(new HashSet<>(names));
                    Written written = write(states, new Random(seed));

                    XmiMachine read = read(written.document()).get(0);

                    StateMachine machine = read.toStateMachine();
                    assertThat(machine.initial()).isEqualTo(written.expected().initial());
                    assertThat(machine.states()).isEqualTo(written.expected().states());
                    assertThat(machine.events()).isEqualTo(written.expected().events());
                    assertThat(machine.transitions())
                            .containsExactlyInAnyOrderElementsOf(
                                    written.expected().transitions());
                });
    }

    private record Written(String document, StateMachine expected) {}

    private static org.quicktheories.core.Gen<String> names() {
        return lists().of(integers().between(0, PIECES.length - 1))
                .ofSizeBetween(1, 6)
                .map(indices -> {
                    StringBuilder name = new StringBuilder();
                    indices.forEach(index -> name.append(PIECES[index]));
                    // Several line breaks in a row become one space, so a name has no two spaces in a row.
                    String single = name.toString().strip().replaceAll(" +", " ");
                    return single.isEmpty() ? "blank" : single;
                });
    }

    private static Written write(List<String> states, Random random) {
        AstahDocument.Machine machine = new AstahDocument.Machine("m", "M");
        StateMachineBuilder expected = StateMachine.named("M");
        int first = random.nextInt(states.size());
        machine.initial("i", "s" + first);
        expected.initial(states.get(first));
        for (int i = 0; i < states.size(); i++) {
            machine.state("s" + i, blanksAround(states.get(i), random));
            expected.state(states.get(i));
        }
        Set<String> used = new HashSet<>();
        for (int i = 0; i < 2 * states.size(); i++) {
            int source = random.nextInt(states.size());
            int target = random.nextInt(states.size());
            String event = "on " + states.get(random.nextInt(states.size()));
            if (used.add(source + event)) {
                machine.transition("t" + i, "s" + source, blanksAround(event, random), "s" + target);
                expected.transition(states.get(source), event, states.get(target));
            }
        }
        return new Written(new AstahDocument().add(machine).text(), expected.build());
    }

    private static String blanksAround(String name, Random random) {
        String[] blanks = {"", "", " ", "\n", "\r\n", "\t "};
        return blanks[random.nextInt(blanks.length)]
                + name.replace(" ", random.nextBoolean() ? "\n" : " ")
                + blanks[random.nextInt(blanks.length)];
    }

    private static List<XmiMachine> read(String document) {
        return ModelFile.read("F.xml", new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)))
                .machines();
    }
}
