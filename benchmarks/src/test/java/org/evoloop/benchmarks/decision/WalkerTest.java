package org.evoloop.benchmarks.decision;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class WalkerTest {
    private static final int ROUNDS = 2_000;

    private static long round(Walker walker, Walk walk) {
        long before = walker.actions();
        for (int event = 0; event < walk.way().size(); event++) {
            walker.fire(walk.way().get(event));
        }
        return walker.actions() - before;
    }

    @ParameterizedTest
    @EnumSource(Library.class)
    void takesATransitionOnEveryEventOfItsWay(Library library) {
        Walk walk = Walk.robot();
        Walker walker = library.walk(walk);
        for (int round = 0; round < 3; round++) {
            assertThat(round(walker, walk)).isEqualTo(walk.way().size());
        }
        Walk chain = Walk.chain(10);
        assertThat(round(library.walk(chain), chain)).isEqualTo(1);
    }

    /** Exact on any machine, however busy. */
    @Test
    void ourDecisionsAllocateNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        Walk walk = Walk.robot();
        Walker walker = Library.EVOLOOP.walk(walk);
        round(walker, walk);
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int round = 0; round < ROUNDS; round++) {
            round(walker, walk);
        }
        assertThat((threads.getCurrentThreadAllocatedBytes() - before) / ROUNDS).isZero();
    }
}
