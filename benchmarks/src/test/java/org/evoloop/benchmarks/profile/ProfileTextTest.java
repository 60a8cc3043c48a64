package org.evoloop.benchmarks.profile;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.profile.Profile.Allocation;
import org.evoloop.benchmarks.profile.Profile.Load;
import org.evoloop.benchmarks.profile.Profile.Stack;
import org.junit.jupiter.api.Test;

class ProfileTextTest {
    @Test
    void showsWhatRanAndItsCallers() {
        Profile profile = new Profile(
                new Load(0.5, 0.25),
                Map.of(
                        new Stack("main", List.of("A.a", "B.b", "A.a")), 3L,
                        new Stack("main", List.of("A.a", "B.b")), 1L),
                Map.of(new Allocation("byte[]", "B.b"), 600L, new Allocation("Thing", "A.a"), 200L));

        assertThat(ProfileText.of(profile)).isEqualToNormalizingNewlines("""
                4 samples; 50 % of all processors taken, and 25 % by the kernel for it
                  threads
                   100.0 %  main
                  methods that ran
                    75.0 %  A.a
                    25.0 %  B.b
                  methods that ran or had called what ran
                   100.0 %  A.a
                   100.0 %  B.b
                  allocated bytes, estimated
                    75.0 %  byte[] in B.b
                    25.0 %  Thing in A.a
                """);
    }

    @Test
    void saysThatNothingWasAllocated() {
        assertThat(ProfileText.of(new Profile(new Load(0, 0), Map.of(), Map.of())))
                .startsWith("0 samples;")
                .endsWith("  nothing was allocated\n");
    }
}
