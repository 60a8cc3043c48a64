package org.evoloop.benchmarks.profile;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProfileTest {
    private long sum;
    private long[] last = {};

    private void spin() {
        for (int index = 0; index < 100_000; index++) {
            sum += index ^ sum;
        }
        last = new long[10_000];
    }

    @Test
    void findsTheMethodThatRanAndWhatItAllocated(@TempDir Path directory) throws Exception {
        Path file = directory.resolve("spin.jfr");

        Recorder.record(file, Duration.ofMillis(700), this::spin);
        Profile profile = Profile.read(file);

        String spin = ProfileTest.class.getName() + ".spin";
        assertThat(profile.samples().keySet())
                .as("call stacks, from the measured method on; the result is %s, %s", sum, last.length)
                .anySatisfy(stack -> assertThat(stack.methods()).contains(spin))
                .noneSatisfy(stack -> assertThat(stack.methods()).contains(Recorder.class.getName() + ".record"));
        assertThat(profile.allocations()).containsKey(new Profile.Allocation("long[]", spin));
        assertThat(profile.load().user()).isPositive();
    }
}
