package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.evoloop.engine.codec.ByteItems;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.junit.jupiter.api.Test;

/** A journal's models use the device as those that wrote it, and a journal of others is told apart. */
class MachineBytesTest {
    private static final State BOOST = new State("Boost");

    private static StateMachineBuilder air() {
        return StateMachine.named("air")
                .initial("Cool")
                .transition("Cool", "turbo", "Turbo")
                .transition("Cool", "boost", "Boost");
    }

    private static StateMachine copy(StateMachine machine) {
        ByteWriter bytes = ByteWriter.withTable();
        MachineBytes.write(bytes, machine);
        ByteItems cursor = ByteItems.withTable(bytes.array());
        cursor.goTo(0, bytes.length());
        StateMachine read = MachineBytes.read(cursor);
        cursor.endsAll();
        return read;
    }

    @Test
    void keepsDeviceStatesAndSends() {
        StateMachine kept = copy(air().deviceState("Boost", "Turbo")
                .sends("Boost", "swing")
                .sends("Boost", "light")
                .inheritedDeviceState("Turbo", "Turbo")
                .build());

        assertThat(kept.deviceState(BOOST)).isEqualTo("Turbo");
        assertThat(kept.inheritsDeviceState(BOOST)).isFalse();
        assertThat(kept.sends(BOOST)).containsExactly(new Event("swing"), new Event("light"));
        assertThat(kept.inheritsDeviceState(new State("Turbo"))).isTrue();
        assertThat(kept.deviceState(new State("Cool"))).isNull();
    }

    @Test
    void theFingerprintTellsThemApart() {
        StateMachine original = air().build();
        assertThat(fingerprints(
                        original,
                        air().build(),
                        air().deviceState("Boost", "Turbo").build(),
                        air().deviceState("Boost", "Cool").build(),
                        air().sends("Boost", "turbo").build()))
                .doesNotHaveDuplicates();
    }

    private static String[] fingerprints(StateMachine original, StateMachine... evolved) {
        return Arrays.stream(evolved)
                .map(each -> Fingerprint.of(new ModelPair(original, each)))
                .toArray(String[]::new);
    }
}
