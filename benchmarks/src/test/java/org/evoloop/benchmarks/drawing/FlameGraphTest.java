package org.evoloop.benchmarks.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.profile.Profile;
import org.evoloop.benchmarks.profile.Profile.Load;
import org.evoloop.benchmarks.profile.Profile.Stack;
import org.junit.jupiter.api.Test;

class FlameGraphTest {
    @Test
    void isAsWideAsSeenOften() {
        String svg = FlameGraph.svg(
                "It & more",
                new Profile(
                        new Load(0, 0),
                        Map.of(
                                new Stack("main", List.of("org.evoloop.A.run", "java.util.Map.get")), 3L,
                                new Stack("main", List.of("org.evoloop.A.run")), 1L),
                        Map.of()));

        assertThat(svg.lines())
                .containsSubsequence(
                        "<title>It &amp; more</title>",
                        "<g><title>main: 100.0 %</title>",
                        "<rect class=\"thread\" x=\"10\" y=\"70\" width=\"1180\" height=\"18\" rx=\"0\"/>",
                        "<g><title>org.evoloop.A.run: 100.0 %</title>",
                        "<rect class=\"ours\" x=\"10\" y=\"88\" width=\"1180\" height=\"18\" rx=\"0\"/>",
                        "<g><title>java.util.Map.get: 75.0 %</title>",
                        "<rect class=\"other\" x=\"10\" y=\"106\" width=\"885\" height=\"18\" rx=\"0\"/>");
    }

    @Test
    void namesAsMuchAsThereIsRoomFor() {
        assertThat(FlameGraph.shorten("org.evoloop.loop.Monitor.run", 11)).isEqualTo("Monitor.run");
        assertThat(FlameGraph.shorten("org.evoloop.loop.Monitor.run", 10)).isEqualTo("run");
        assertThat(FlameGraph.shorten("org.evoloop.loop.Monitor.run", 2)).isEmpty();
    }
}
