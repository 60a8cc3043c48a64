package org.evoloop.models.flat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.longs;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;

/** Reading what was written gives the same machine. */
class AstahWriterTest {
    private static final List<String> NAMES = List.of(
            "On", "Off", "(A, B)", "Outer.Inner", "掃除中", "a+b %41", "say \"hi\" & <go>", "two words", "S [history X]");
    private static final List<String> EVENTS =
            List.of("press", "tm(2s)", "時間切れ", "a/b", "go [now]", "after 2 s", "completion(On)", "100%");
    private static final List<String> GUARDS = List.of("hot", "x > 1", "準備完了");
    private static final List<String> EFFECTS = List.of("beep()", "save; quit", "点灯");

    private static StateMachine random(long seed) {
        Random random = new Random(seed);
        StateMachineBuilder builder = StateMachine.named(pick(List.of("m", "機械", "a & b"), random));
        List<String> states = NAMES.subList(0, 1 + random.nextInt(NAMES.size()));
        builder.initial(states.get(0)).initialEffects(some(EFFECTS, random));
        for (String state : states) {
            builder.state(state).activities(state, some(EFFECTS, random));
            if (random.nextInt(4) == 0) {
                builder.deviceState(state, pick(NAMES, random));
            }
            some(EVENTS, random).forEach(event -> builder.sends(state, event));
            for (String event : EVENTS) {
                branches(builder, state, event, states, random);
            }
        }
        return builder.build();
    }

    /** Guarded ones first, the one without a guard last, as in a flattened machine. */
    private static void branches(
            StateMachineBuilder builder, String state, String event, List<String> states, Random random) {
        for (int i = random.nextInt(3); i > 0; i--) {
            List<String> guards = List.of(GUARDS.get(i));
            builder.transition(transition(state, new Event(event, guards), states, random), "");
        }
        if (random.nextInt(3) == 0) {
            builder.transition(transition(state, new Event(event), states, random), "");
        }
    }

    private static Transition transition(String state, Event event, List<String> states, Random random) {
        boolean internal = random.nextInt(5) == 0;
        String target = internal ? state : pick(states, random);
        return new Transition(new State(state), event, new State(target), some(EFFECTS, random), internal);
    }

    private static <T> T pick(List<T> all, Random random) {
        return all.get(random.nextInt(all.size()));
    }

    private static List<String> some(List<String> all, Random random) {
        return all.stream().filter(each -> random.nextInt(4) == 0).toList();
    }

    static StateMachine readBack(StateMachine machine) {
        byte[] bytes = AstahWriter.write(machine).getBytes(StandardCharsets.UTF_8);
        return ModelFile.read("written.xml", new ByteArrayInputStream(bytes)).only();
    }

    private static void assertReadsBack(StateMachine machine) {
        StateMachine read = readBack(machine);
        assertThat(read.name()).isEqualTo(machine.name());
        assertThat(read.initial()).isEqualTo(machine.initial());
        assertThat(read.initialEffects()).isEqualTo(machine.initialEffects());
        assertThat(read.states()).containsExactlyInAnyOrderElementsOf(machine.states());
        assertThat(read.events()).containsExactlyInAnyOrderElementsOf(machine.events());
        for (State state : machine.states()) {
            assertThat(read.activities(state)).isEqualTo(machine.activities(state));
            assertThat(read.deferred(state)).isEqualTo(machine.deferred(state));
            assertThat(read.deviceState(state)).isEqualTo(machine.deviceState(state));
            assertThat(read.sends(state)).containsExactlyElementsOf(machine.sends(state));
            assertThat(plain(read.transitionsFrom(state)))
                    .containsExactlyInAnyOrderElementsOf(plain(machine.transitionsFrom(state)));
        }
    }

    /** Without the activities that continue, since an internal transition always keeps them. */
    private static List<Transition> plain(List<Transition> transitions) {
        List<Transition> plain = new ArrayList<>();
        for (Transition each : transitions) {
            plain.add(new Transition(each.source(), each.event(), each.target(), each.effects(), each.internal()));
        }
        return plain;
    }

    @Test
    void anyFlatMachineReadsBack() {
        qt().withExamples(60).forAll(longs().all()).checkAssert(seed -> assertReadsBack(random(seed)));
    }

    @Test
    void severalGuardsOfOneTransitionReadBack() {
        assertReadsBack(StateMachine.named("m")
                .initial("A")
                .transition(guarded("B", "hot", "full"), "")
                .transition(guarded("C", "hot"), "")
                .transition(guarded("C"), "")
                .build());
    }

    @Test
    void deferredEventsReadBack() {
        StateMachine machine = StateMachine.named("m")
                .initial("A")
                .transition("A", "e", "B")
                .transition("B", "f", "A")
                .defers("B", new Event("e"))
                .build();

        assertReadsBack(machine);
        assertThat(TransitionTable.write(machine)).contains("B defers e\n");
    }

    @Test
    void deviceStatesReadBack() {
        StateMachine machine = StateMachine.named("m")
                .initial("A")
                .transition("A", "e", "Gap")
                .transition("A", "f", "Inner")
                .deviceState("Gap", "StopUp")
                .sends("Gap", "press")
                .inheritedDeviceState("Inner", "StopUp")
                .build();

        assertReadsBack(machine);
        assertThat(TransitionTable.write(machine)).contains("Gap has the device in StopUp\nGap may send press\n");
        assertThat(AstahWriter.losses(machine))
                .singleElement()
                .asString()
                .startsWith("Inner has the device state StopUp of a state around it, which becomes its own");
    }

    private static Transition guarded(String target, String... guards) {
        return new Transition(new State("A"), new Event("e", List.of(guards)), new State(target), List.of("x"), false);
    }
}
