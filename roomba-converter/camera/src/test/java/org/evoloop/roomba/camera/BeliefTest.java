package org.evoloop.roomba.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class BeliefTest {
    private static final Optional<Sighting> THERE = Optional.of(new Sighting(1000, 0.1));
    private static final Optional<Sighting> NEARLY_THERE = Optional.of(new Sighting(960, 0.2));

    private final Belief belief = new Belief(3);

    @Test
    void believesTheThirdFrameInARow() {
        assertThat(belief.after(THERE)).isEmpty();
        assertThat(belief.after(NEARLY_THERE)).isEmpty();
        assertThat(belief.after(THERE)).isEqualTo(THERE);
        assertThat(belief.after(NEARLY_THERE)).isEqualTo(NEARLY_THERE);
    }

    @Test
    void startsAgainAfterAFrameWithoutIt() {
        belief.after(THERE);
        belief.after(THERE);
        assertThat(belief.after(Optional.empty())).isEmpty();
        assertThat(belief.after(THERE)).isEmpty();
        assertThat(belief.after(THERE)).isEmpty();
        assertThat(belief.after(THERE)).isEqualTo(THERE);
    }

    @Test
    void startsAgainWhenItIsSuddenlyElsewhere() {
        for (Sighting elsewhere : new Sighting[] {new Sighting(1000, 0.9), new Sighting(2000, 0.1)}) {
            Belief fresh = new Belief(2);
            fresh.after(THERE);
            assertThat(fresh.after(THERE)).isEqualTo(THERE);
            assertThat(fresh.after(Optional.of(elsewhere))).isEmpty();
            assertThat(fresh.after(Optional.of(elsewhere))).hasValue(elsewhere);
        }
    }
}
