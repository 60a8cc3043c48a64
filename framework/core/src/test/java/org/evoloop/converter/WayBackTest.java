package org.evoloop.converter;

import static java.time.Duration.ofSeconds;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A heater that is on a way without return, if its models let it. */
class WayBackTest {
    private static final Duration LONG = ofSeconds(20);
    private static final StateMachine DEVICE =
            machine("heater", "Cold key -> Warm", "Warm key -> Cold", "Broken key -> Cold");

    private final PushMonitor key = new PushMonitor("Key") {
        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("key");
        }
    };
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch obeyed = new CountDownLatch(1);
    private final CountDownLatch settled = new CountDownLatch(1);
    private volatile boolean hangs;
    private SystemEventConverter converter;

    @BeforeEach
    void start() {
        // The clock stands still: no deadline but that of 0 s is ever reached.
        converter = new SystemEventConverter(LoopConfig.defaults("heater", new ManualClock()));
        converter.addMonitor(key);
        converter.addExecute(new EventExecute("Wire") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("key");
            }

            @Override
            protected void send(Step step) throws Exception {
                if (hangs) {
                    begun.countDown();
                    obeyed.await();
                }
            }
        });
        converter.addKnowledge(models("Warm key -> Cold", "Broken key -> Cold"));
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        obeyed.countDown();
        converter.close();
    }

    /** New models that go on like this after the heater was switched on. */
    private StateKnowledge models(String... lines) {
        String[] all = new String[lines.length + 1];
        all[0] = "Cold key -> Warm";
        System.arraycopy(lines, 0, all, 1, lines.length);
        return knowledge(machine("new", all));
    }

    private StateKnowledge knowledge(StateMachine evolved) {
        return new StateKnowledge(new ModelPair(DEVICE, evolved)) {
            @Override
            protected void registerNewFunctions() {
                if (evolved.hasState(new State("Locked"))) {
                    function("Locked", visit -> settled.countDown());
                }
            }
        };
    }

    @Test
    void thePairsInWhichOthersTakeOverNeedAWayBackToo() {
        // From its own beginning it only stays in Cold; from Warm, where it may take over, it leads to Locked for good.
        StateKnowledge night = staysCold("night", "Locked key -> Locked");
        assertThatThrownBy(() -> converter.evolve(Evolution.to(night)))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("no way leads back")
                .hasMessageContaining("Locked): the next new model has no state Locked; map it");
        assertThat(converter.knowledge().models().evolved().name()).isEqualTo("new");

        assertThat(converter
                        .evolve(Evolution.to(staysCold("home", "Locked key -> Warm")))
                        .model())
                .isEqualTo("home");
    }

    private StateKnowledge staysCold(String name, String locked) {
        return knowledge(machine(name, "Cold key -> Cold", "Warm key -> Locked", "Broken key -> Cold", locked));
    }

    @Test
    void aRollbackEndsAtOnceWhereNoEventLeadsOn() throws Exception {
        // No event leads to Broken, so that nobody could know that Locked is reached.
        converter.evolve(Evolution.to(models("Warm key -> Cold", "Broken key -> Locked", "Locked key -> Locked")));
        key.push(key.foundIn("Broken"));
        key.press("key");
        settled.await();
        assertTimeoutPreemptively(LONG, () -> {
            assertThatThrownBy(() -> converter.rollBack())
                    .isInstanceOf(EvolutionException.class)
                    .hasMessageContaining("no state Locked")
                    .hasMessageEndingWith("no event leads to where it is possible");
            assertThatThrownBy(() -> converter.evolve(Evolution.to(models("Warm key -> Cold", "Broken key -> Cold"))
                            .withoutWayBack()))
                    .as("nor does any other evolution wait")
                    .isInstanceOf(EvolutionException.class);
        });
    }

    @Test
    void aRollbackEndsAtItsDeadline() throws Exception {
        converter.evolve(Evolution.to(models("Warm key -> Cold", "Broken key -> Cold")));
        hangs = true;
        key.press("key");
        begun.await();
        assertTimeoutPreemptively(
                LONG,
                () -> assertThatThrownBy(() -> converter.rollBack(Duration.ZERO))
                        .isInstanceOf(EvolutionException.class)
                        .hasMessageContaining("within 0 s: an event is in progress"));
        assertThatThrownBy(() -> converter.rollBack(ofSeconds(-1))).isInstanceOf(IllegalArgumentException.class);
    }
}
