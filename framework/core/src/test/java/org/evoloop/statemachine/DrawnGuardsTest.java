package org.evoloop.statemachine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** A transition is written in code as it is drawn. */
class DrawnGuardsTest {
    private static Event eventOf(String label) {
        return StateMachine.named("lamp")
                .initial("Off")
                .transition("Off", label, "On")
                .build()
                .transitions()
                .iterator()
                .next()
                .event();
    }

    @Test
    void guardsFollowTheEvent() {
        assertThat(eventOf("press [dark]")).isEqualTo(new Event("press", List.of("dark")));
        assertThat(eventOf("press twice [dark] [x > 3]")).isEqualTo(new Event("press twice", List.of("dark", "x > 3")));
    }

    @Test
    void otherBracketsArePartOfTheName() {
        assertThat(eventOf("press[1]")).isEqualTo(new Event("press[1]"));
        assertThat(eventOf("[dark]")).isEqualTo(new Event("[dark]"));
        assertThat(eventOf("press [dark] now")).isEqualTo(new Event("press [dark] now"));
    }
}
