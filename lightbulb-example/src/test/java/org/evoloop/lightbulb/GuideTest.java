package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The guide shows a test that runs. */
class GuideTest {
    @Test
    void theFirstScenarioIsTheOneThatIsRun() throws IOException {
        String test = Files.readString(Path.of("src/test/java/org/evoloop/lightbulb/FirstScenarioTest.java"));
        String shown = test.substring(test.indexOf("class FirstScenarioTest"));
        assertThat(shown.lines().count()).as("lines of a first test").isLessThanOrEqualTo(20);
        assertThat(Path.of(System.getProperty("evoloop.root"), "docs", "testing.md"))
                .content()
                .contains("```java\n" + shown + "```");
    }
}
