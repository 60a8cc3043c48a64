package org.evoloop.models.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;

/** PlantUML names what is in the second region of a state only there, and nothing else there. */
class PlantUmlTest {
    private static String written(String content) {
        String document = "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0'>" + content + "</scxml>";
        return PlantUml.write(
                List.of(ModelFile.read("F.scxml", new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)))
                        .findOnly()
                        .statechart()));
    }

    private static String parallel(String inSecond, String around) {
        return "<state id='a'><transition event='e' target='c2 d2'/></state><parallel id='p'>"
                + "<state id='c'><state id='c1'/><state id='c2'/></state>"
                + "<state id='d'><state id='d1'>" + inSecond + "</state><state id='d2'/></state>" + around
                + "</parallel>";
    }

    @Test
    void aForkIntoSeveralRegionsIsDrawnToTheirState() {
        assertThat(written(parallel("", "")).lines())
                .containsSubsequence(
                        "state \"p\" as v2 {",
                        "    state \"c2\" as v7",
                        "  --",
                        "}",
                        "state \"fork\" as v13 <<fork>>",
                        "v13 --> v7",
                        "v13 --> v2 : (to d2)",
                        "v1 --> v13 : e");
    }

    @Test
    void aTransitionThatLeavesARegionIsDrawnFromItsState() {
        assertThat(written(parallel("<transition event='stop' target='a'/>", ""))
                        .lines())
                .containsSubsequence("  --", "    state \"d1\" as v11", "}", "v2 --> v1 : stop (from d1)", "@enduml")
                .noneMatch(line -> line.startsWith("  ") && line.contains("stop"));
    }

    @Test
    void aTransitionWithinARegionStaysThere() {
        assertThat(written(parallel("<transition event='stay' target='d2'/>", ""))
                        .lines())
                .containsSubsequence("  --", "    v11 --> v12 : stay", "}");
    }

    @Test
    void aTransitionBetweenTwoRegionsBelongsToNeither() {
        assertThat(written("<state id='a'><parallel id='p'><state id='c'><state id='c1'>"
                                + "<transition event='over' target='d1'/></state></state>"
                                + "<state id='d'><state id='d1'/></state></parallel></state>")
                        .lines())
                .containsSubsequence("    --", "  }", "v7 --> v3 : over (to d1)", "@enduml");
    }
}
