package org.evoloop.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Checks large machines; docs/models.md quotes its output. */
@Tag("slow")
class CheckGrowthTest {
    private static final int WARM_UPS = 5;

    /** A ring in which every tenth state gets a new successor, from which a detour of two events leads back. */
    private static ModelPair ring(int size) {
        return new ModelPair(
                around(StateMachine.named("original").initial("S0"), size).build(),
                detours(around(StateMachine.named("new").initial("S0"), size), size)
                        .build());
    }

    private static StateMachineBuilder around(StateMachineBuilder builder, int size) {
        for (int state = 0; state < size; state++) {
            builder.transition("S" + state, "next", "S" + (state + 1) % size);
            builder.transition("S" + state, "back", "S" + (state + size - 1) % size);
            builder.transition("S" + state, "reset", "S0");
        }
        return builder;
    }

    private static StateMachineBuilder detours(StateMachineBuilder builder, int size) {
        for (int state = 0; state < size; state += 10) {
            builder.transition("S" + state, "wait", "New" + state);
            builder.transition("New" + state, "done", "S" + (state + 2) % size);
        }
        return builder;
    }

    @ParameterizedTest
    @ValueSource(ints = {1_000, 10_000, 100_000})
    void aLargeMachineIsCheckedInTimeThatGrowsWithItsPairs(int size) {
        CheckInput input = CheckInput.of(ring(size));
        for (int run = 0; run < WARM_UPS; run++) {
            assertThat(Check.run(CheckInput.of(ring(1_000)))).hasSize(100);
        }
        long begin = System.nanoTime();
        List<Finding> findings = Check.run(input);
        long tookNanos = System.nanoTime() - begin;
        assertThat(findings).hasSize(size / 10).extracting(Finding::rule).containsOnly(Rule.SWALLOWED_EVENT);
        int pairs = DecisionTable.compile(input.pair(), input.device())
                .configurations()
                .size();
        assertThat(pairs).isEqualTo(size + size / 10);
        System.out.printf("%d states: %d pairs, checked in %d ms%n", size, pairs, tookNanos / 1_000_000);
    }
}
