package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Each invariant of exploration is violated if a mechanism that maintains it is removed. */
class MutationsTest {

    @ParameterizedTest
    @EnumSource
    void isNoticed(Mutation mutation) {
        assertNoticed(mutation);
    }

    @ParameterizedTest
    @EnumSource
    void isNoticedWhereAStateNeedsTheDevice(DeviceStateMutation mutation) {
        assertNoticed(mutation);
    }

    private static void assertNoticed(Removal mutation) {
        assertThat(Exploration.of(mutation.scene(), Wiring.REAL, 20).violation())
                .as("with the mechanism")
                .isEmpty();
        assertThat(Exploration.of(mutation.scene(), mutation.wiring(), 20).violation())
                .as("without it")
                .startsWith(mutation.invariant() + ":");
    }
}
