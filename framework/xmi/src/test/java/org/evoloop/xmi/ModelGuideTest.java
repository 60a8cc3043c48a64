package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** The examples of the page on models without Astah can be read, and all mean the same. */
class ModelGuideTest {

    @Test
    void bothExamplesAreTheSameMachine() throws IOException {
        String page = Files.readString(Path.of(System.getProperty("evoloop.root"), "models", "scxml-and-uml2.md"));
        List<StateMachine> machines = Pattern.compile("(?s)```xml\n(.*?)```")
                .matcher(page)
                .results()
                .map(ModelGuideTest::machine)
                .toList();

        assertThat(machines).hasSize(2);
        assertThat(machines.get(0).transitions())
                .hasSize(4)
                .isEqualTo(machines.get(1).transitions());
        assertThat(machines.get(0).initial()).isEqualTo(machines.get(1).initial());
    }

    private static StateMachine machine(MatchResult example) {
        return ChartText.machines(example.group(1)).get(0).toStateMachine();
    }
}
