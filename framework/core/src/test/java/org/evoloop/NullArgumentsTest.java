package org.evoloop;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.EventNames;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Whoever builds models and passes null reads what is null. */
@SuppressWarnings("NullAway")
class NullArgumentsTest {
    private static final State OFF = new State("Off");
    private static final Event PRESS = new Event("press");
    private static final List<String> ONE_IS_NULL = Collections.singletonList(null);

    private static StateMachineBuilder lamp() {
        return StateMachine.named("lamp").initial("Off");
    }

    private static Arguments of(String message, ThrowingCallable call) {
        return arguments(message, call);
    }

    static Stream<Arguments> builders() {
        String activities = "the activities of a state are null, or one of them is; List.of() are none";
        String effects = "the initial effects are null, or one of them is; List.of() are none";
        return Stream.of(
                of("the name of a state machine is null", () -> StateMachine.named(null)),
                of("the name of a state is null", () -> lamp().initial(null)),
                of("the name of a state is null", () -> lamp().state(null)),
                of("the name of an event is null", () -> lamp().event((String) null)),
                of("the name of an event is null", () -> lamp().spontaneous((String) null)),
                of("the name of a state is null", () -> lamp().transition(null, "press", "On")),
                of("the name of an event is null", () -> lamp().transition("Off", null, "On")),
                of("the name of a state is null", () -> lamp().transition("Off", "press", null)),
                of(
                        "the place of a transition is null; \"\" if it has none",
                        () -> lamp().transition("Off", "press", "On", null)),
                of("a transition of a state machine is null", () -> lamp().transition((Transition) null, "")),
                of("a state of a state machine is null", () -> lamp().transitions(null, List.of())),
                of("the transitions that leave a state are null", () -> lamp().transitions(OFF, null)),
                of(
                        "a transition of a state machine is null",
                        () -> lamp().transitions(OFF, Arrays.asList((Transition) null))),
                of("the event that a state defers is null", () -> lamp().defers("Off", null)),
                of(effects, () -> lamp().initialEffects(null)),
                of(effects, () -> lamp().initialEffects(ONE_IS_NULL)),
                of(activities, () -> lamp().activities("Off", null)),
                of(activities, () -> lamp().activities("Off", ONE_IS_NULL)),
                of("a state of a state machine is null", () -> lamp().drawn(null, OFF, List.of(), List.of(), false)),
                of(
                        "the state without memory is null; for most states it is the state itself",
                        () -> lamp().drawn(OFF, null, List.of(), List.of(), false)),
                of(activities, () -> lamp().drawn(OFF, OFF, null, List.of(), false)),
                of(
                        "the paths of a state are null, or one of them is; its name is its path at the top",
                        () -> lamp().drawn(OFF, OFF, List.of(), null, false)));
    }

    static Stream<Arguments> machines() {
        String guards = "the guards of an event are null, or one of them is; List.of() are none";
        String effects = "the effects of a transition are null, or one of them is; List.of() are none";
        String keeps = "what a transition keeps is null, or one of the names is; Set.of() is nothing";
        Map<State, String> unnamed = new HashMap<>();
        unnamed.put(OFF, null);
        return Stream.of(
                of("the name of a state is null", () -> new State(null)),
                of("the name of an event is null", () -> new Event(null)),
                of(guards, () -> new Event("press", null)),
                of(guards, () -> new Event("press", ONE_IS_NULL)),
                of("the name of an event is null", () -> Event.withTimeUnit(null, ChronoUnit.SECONDS)),
                of(
                        "the unit of a time trigger is null; use MILLIS or SECONDS",
                        () -> Event.withTimeUnit("after 2", null)),
                of("the source of a transition is null", () -> new Transition(null, PRESS, OFF)),
                of("the event of a transition is null", () -> new Transition(OFF, null, OFF)),
                of("the target of a transition is null", () -> new Transition(OFF, PRESS, null)),
                of(effects, () -> new Transition(OFF, PRESS, OFF, null, false)),
                of(effects, () -> new Transition(OFF, PRESS, OFF, ONE_IS_NULL, false)),
                of(keeps, () -> new Transition(OFF, PRESS, OFF, List.of(), false, null)),
                of(keeps, () -> new Transition(OFF, PRESS, OFF, List.of(), false, new HashSet<>(ONE_IS_NULL))),
                of("the name of a state machine is null", () -> lamp().build().withName(null)),
                of(
                        "the new names of states are null; Map.of() are none",
                        () -> lamp().build().withStateNames(null)),
                of("the name of a state is null", () -> lamp().build().withStateNames(unnamed)),
                of("the state is null", () -> lamp().build().activities(null)),
                of("the state is null", () -> lamp().build().paths(null)),
                of("the state is null", () -> lamp().build().isEnd(null)));
    }

    static Stream<Arguments> evolutions() {
        StateMachine lamp = lamp().build();
        ModelPair pair = new ModelPair(lamp, lamp);
        DeviceEvents none = new DeviceEvents(Set.of(), Set.of());
        return Stream.of(
                of("the original model is null", () -> new ModelPair(null, lamp)),
                of("the new model is null", () -> new ModelPair(lamp, null)),
                of("the state is null", () -> pair.isNew(null)),
                of("the device's state is null", () -> new Configuration(null, OFF)),
                of("the evolved system's state is null", () -> pair.initial().withEvolved(null)),
                of("the values are null; Values.NONE are none", () -> new Values(null)),
                of("the name of a value is null", () -> Values.of(null, 1)),
                of("the name of a value is null", () -> new Values(Collections.singletonMap(null, 1))),
                of("the name of a value is null", () -> Values.NONE.number(null)),
                of("the reason of a doubt is null", () -> new Occurrence.InDoubt(null, 0)),
                of("the name of a violated property is null", () -> new Occurrence.Violated(null, 0)),
                of("the name of the new model is null", () -> new Occurrence.Evolved(null, 0)),
                of("the events are null; Set.of() are none", () -> new EventNames(null)),
                of("the models are null", () -> EventNames.of(null)),
                of("the events that can be sent are null; Set.of() are none", () -> new DeviceEvents(null, Set.of())),
                of("the device's own events are null; Set.of() are none", () -> new DeviceEvents(Set.of(), null)),
                of("the costs of events are null; Map.of() are none", () -> none.withCosts(null)),
                of("the states not to be passed are null; Set.of() are none", () -> none.withDoNotPass(null)),
                of("the bound guards are null; Set.of() are none", () -> none.withBoundGuards(null)),
                of("what follows on failure is null; Map.of() is nothing", () -> none.withOnFailure(null)),
                of("the models are null", () -> DecisionTable.compile(null, none)),
                of("the device's events are null", () -> DecisionTable.compile(pair, null)));
    }

    static Stream<Arguments> mappings() {
        Mapping byName = Mapping.byName();
        Mapping.TimerOf timer = new Mapping.TimerOf(OFF, "tm(2s)");
        return Stream.of(
                of("the state to be mapped is null", () -> byName.withState(null, OFF)),
                of("the successor of a state is null", () -> byName.withState(OFF, null)),
                of("the state to be mapped is null", () -> byName.withDeviceState(null, OFF)),
                of("the successor of a state is null", () -> byName.withDeviceState(OFF, null)),
                of("the timer to be mapped is null", () -> byName.withTimer(null, "tm(3s)")),
                of("the successor of a timer is null", () -> byName.withTimer(timer, null)),
                of("the timer to be mapped is null", () -> byName.withRestarted(null)),
                of("the state to be mapped is null", () -> byName.withFunction(null, true)),
                of("the state of a timer is null", () -> new Mapping.TimerOf(null, "tm(2s)")),
                of("the name of a timer is null", () -> new Mapping.TimerOf(OFF, null)),
                of(
                        "the successors of states are null",
                        () -> new Mapping(Map.of(), null, Map.of(), Set.of(), Set.of(), Set.of())));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource({"builders", "machines", "evolutions", "mappings"})
    void theMessageSaysWhatIsNull(String message, ThrowingCallable call) {
        assertThatThrownBy(call).isInstanceOf(NullPointerException.class).hasMessage(message);
    }

    @Test
    void aBlankGuardIsRefused() {
        assertThatThrownBy(() -> new Event("press", List.of("hot", " ")))
                .isInstanceOf(ModelException.class)
                .hasMessage("a guard of event press is blank; write its condition or leave it out");
    }
}
