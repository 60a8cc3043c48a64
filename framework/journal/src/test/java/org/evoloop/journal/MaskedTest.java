package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Input;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Secrets are in no file, by whatever path they might get there. */
class MaskedTest {
    private static final String SECRET = "4711-secret";

    @TempDir
    private Path directory;

    private static Input press(String event, String value, Object of) {
        return new Input.Observed(new Occurrence.Heard(
                new Event(event), new Values(Map.of(value, of, "by", "owner")), Source.CONTROLLER, 0, 1));
    }

    private String files() throws IOException {
        StringBuilder all = new StringBuilder();
        for (Path file : Directory.segments(directory)) {
            all.append(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1));
        }
        return all.toString();
    }

    @Test
    void neitherARecordNorASnapshotHoldsIt() throws Exception {
        Journal journal = Journal.in(directory)
                .withForcing(Forcing.NEVER)
                .withSegmentBytes(1 << 16)
                .withMasked("pin", "Spot.code");
        try (JournaledCore kept = new JournaledCore(directory, journal)) {
            kept.input(new Input.Opened(0));
            kept.input(press("Clean", "pin", SECRET));
            kept.input(new Input.Ready());
            for (int waiting = 0; waiting < 3; waiting++) {
                kept.input(press("Spot", "code", SECRET));
            }
            while (Directory.segments(directory).size() < 3) {
                kept.input(press("Clean", "code", "not masked"));
            }
            assertThat(files()).doesNotContain(SECRET).contains("not masked", "owner");
            assertThat(kept.core.snapshot().toString())
                    .as("the core continues with it")
                    .contains(SECRET);

            Snapshot recovered = kept.recovered(directory.resolve("copy"));
            assertThat(recovered).isEqualTo(new Masks(Set.of("pin", "Spot.code")).of(kept.core.snapshot()));
            Values waiting = recovered.waiting().get(0).occurrence().values();
            assertThat(waiting.text("by")).isEqualTo("owner");
            assertThatThrownBy(() -> waiting.text("code")).hasMessageContaining("there is no String named code");
        }
    }

    @Test
    void aBlankNameIsRefused() {
        assertThatThrownBy(() -> Journal.in(directory).withMasked(" "))
                .hasMessageContaining("a masked value has no name");
    }
}
