package org.evoloop.statemachine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class StateMachineTest {
    private final StateMachine lamp = StateMachine.named("lamp")
            .initial("off")
            .transition("off", "switch", "on")
            .transition("on", "switch", "off")
            .build();

    @Test
    void answersThePapersQuestions() {
        State off = new State("off");
        Event flip = new Event("switch");

        assertThat(lamp.initial()).isEqualTo(off);
        assertThat(lamp.states()).containsExactly(off, new State("on"));
        assertThat(lamp.events()).containsExactly(flip);
        assertThat(lamp.transitions())
                .containsExactly(
                        new Transition(off, flip, new State("on")), new Transition(new State("on"), flip, off));
        assertThat(lamp.hasState(off)).isTrue();
        assertThat(lamp.hasState(new State("dim"))).isFalse();
        assertThat(lamp.hasTransition(off, flip)).isTrue();
        assertThat(lamp.hasTransition(off, new Event("timeout"))).isFalse();
        assertThat(lamp.nextState(off, flip)).contains(new State("on"));
        assertThat(lamp.nextState(new State("dim"), flip)).isEmpty();
        assertThat(lamp.transitionsFrom(off)).hasSize(1);
        assertThat(lamp.transitionsFrom(new State("dim"))).isEmpty();
    }

    @Test
    void cannotBeChanged() {
        assertThatThrownBy(() -> lamp.states().clear()).isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(() -> lamp.events().clear()).isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(() -> lamp.transitions().clear()).isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void isNotChangedByItsBuilder() {
        StateMachineBuilder builder = StateMachine.named("lamp").initial("Off").transition("Off", "press", "On");
        StateMachine built = builder.build();

        StateMachine dimmed = builder.transition("Off", "hold", "Dim").build();

        assertThat(built.states()).containsExactly(new State("Off"), new State("On"));
        assertThat(built.transitions()).hasSize(1);
        assertThat(dimmed.states()).hasSize(3);
        assertThat(dimmed.transitionsFrom(new State("Off"))).hasSize(2);
    }

    @Test
    void anEventDrawnOnlyWithGuardsIsNotAnotherOneForBeingNamed() {
        Event hot = new Event("measured", List.of("hot"));
        StateMachineBuilder builder = StateMachine.named("oven")
                .initial("On")
                .spontaneous("measured")
                .event("press")
                .transition(new Transition(new State("On"), hot, new State("Off")), "");

        StateMachine oven = builder.build();
        assertThat(oven.events()).containsExactly(new Event("press"), hot);
        assertThat(oven.triggers()).containsExactly(new Event("press"), new Event("measured"));
        assertThat(oven.spontaneous()).containsExactly(new Event("measured"));

        StateMachine other = builder.transition("Off", "measured", "On").build();
        assertThat(other.events()).containsExactly(new Event("measured"), new Event("press"), hot);
    }

    @Test
    void otherNamesOfStatesKeepWhatTheDeviceDoesByItself() {
        StateMachine device = StateMachine.named("robot")
                .transition("Spot", "endSpot", "On")
                .initial("Spot")
                .spontaneous("endSpot")
                .build();

        assertThat(device.withStateNames(Map.of(new State("Spot"), "Clean")).spontaneous())
                .containsExactly(new Event("endSpot"));
    }

    @Test
    void namesBothTransitionsThatMakeItNondeterministic() {
        StateMachineBuilder builder = StateMachine.named("robot")
                .initial("Clean")
                .transition("Clean", "Clean", "On", "line 12")
                .transition("Clean", "Clean", "SpotWait", "line 31");

        assertThatThrownBy(builder::build)
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("'robot'")
                .hasMessageContaining("Clean --Clean--> On (line 12)")
                .hasMessageContaining("Clean --Clean--> SpotWait (line 31)");
    }

    @Test
    void refusesTheSameTransitionTwice() {
        assertThatThrownBy(() -> StateMachine.named("m")
                        .initial("A")
                        .transition("A", "e", "B")
                        .transition("A", "e", "B")
                        .build())
                .isInstanceOf(ModelException.class);
    }

    @Test
    void reportsAllProblemsAtOnce() {
        assertThatThrownBy(() -> StateMachine.named("m")
                        .transition("A", "tm(soon)", "B")
                        .transition("A", "tm(soon)", "C")
                        .build())
                .hasMessageContaining("no initial state")
                .hasMessageContaining("tm(soon)")
                .hasMessageContaining("two transitions");
    }

    @Test
    void refusesASecondInitialState() {
        assertThatThrownBy(
                        () -> StateMachine.named("m").initial("A").initial("B").build())
                .hasMessageContaining("two initial states, A and B");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "\n"})
    void refusesNamesOfNothing(String name) {
        assertThatThrownBy(() -> new State(name)).isInstanceOf(ModelException.class);
        assertThatThrownBy(() -> new Event(name)).isInstanceOf(ModelException.class);
    }

    @ParameterizedTest
    @CsvSource({
        "tm(2s), 2000",
        "tm(2 s), 2000",
        "TM( 500ms ), 500",
        "after(2s), 2000",
        "after 2 s, 2000",
        "After 1.5 minutes, 90000",
        "after(0.25 sec), 250",
        "tm(1h), 3600000",
        "after 0 ms, 0",
        "after 2 days, 172800000",
        "PT5S, 5000",
        "PT1M30S, 90000",
        "P1DT2H, 93600000",
        "'PT0,5S', 500",
        "P1W, 604800000",
        "after PT5S, 5000",
        "after(pt5s), 5000",
        "tm( PT0.25S ), 250",
        "PT5S in On, 5000",
        "after PT5S in On, 5000",
    })
    void readsTimeTriggers(String name, long millis) {
        assertThat(new Event(name).timeTrigger()).contains(Duration.ofMillis(millis));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "timeout",
                "switch",
                "afterwards",
                "after lunch",
                "tm",
                "atm(2s)",
                "onLogin(uname, pwd)",
                "P",
                "PT",
                "P1",
                "PD",
                "Pump1S",
                "after Party"
            })
    void takesOtherNamesForOrdinaryEvents(String name) {
        assertThat(new Event(name).timeTrigger()).isEqualTo(Optional.empty());
    }

    @ParameterizedTest
    @CsvSource({
        "after 2, after 2 s",
        "tm(2) in On, tm(2 s) in On",
        "after( 0.5 ), after( 0.5 s )",
        "tm(2ms), tm(2ms)",
        "PT2S, PT2S",
        "after lunch, after lunch",
    })
    void givesTimeTriggersAUnitThatHaveNone(String name, String withUnit) {
        assertThat(Event.withTimeUnit(name, ChronoUnit.SECONDS)).isEqualTo(withUnit);
    }

    @Test
    void namesTheOptionForTimeTriggersWithoutUnit() {
        assertThatThrownBy(() -> new Event("after 2").timeTrigger())
                .isInstanceOf(ModelException.class)
                .hasMessage("time trigger 'after 2' has no unit; write one (ms, s, min, h or d), for example after 2 s,"
                        + " or give --time-unit ms or --time-unit s for all that have none");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "P1M",
                "after P1Y",
                "PT999999999999H",
                "tm(2)",
                "tm()",
                "after(soon)",
                "after 2",
                "after 2 fortnights",
                "tm(-1s)",
                "tm(99999999999h)"
            })
    void refusesTimeTriggersWithoutADuration(String name) {
        assertThatThrownBy(() -> StateMachine.named("m")
                        .initial("A")
                        .transition("A", name, "B")
                        .build())
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(name);
    }

    @Test
    void saysWhereANewStateNeedsTheDeviceAndWhatItsFunctionSends() {
        StateMachine aired = StateMachine.named("door")
                .initial("Closed")
                .transition("Closed", "gap", "Gap")
                .defers("Gap", new Event("press"))
                .deviceState("Gap", "StopUp")
                .sends("Gap", "light")
                .sends("Gap", "beep")
                .build();
        State gap = new State("Gap");
        State airing = new State("Airing");

        assertThat(aired.deviceState(gap)).isEqualTo("StopUp");
        assertThat(aired.deviceState(new State("Closed"))).isNull();
        assertThat(aired.sends(gap)).containsExactly(new Event("light"), new Event("beep"));
        assertThat(aired.sends(new State("Closed"))).isEmpty();
        assertThat(aired.events()).doesNotContain(new Event("light"));

        StateMachine copy = aired.withName("other").withStateNames(Map.of(gap, "Airing"));
        assertThat(copy.deviceState(airing)).isEqualTo("StopUp");
        assertThat(copy.sends(airing)).containsExactly(new Event("light"), new Event("beep"));
        assertThat(copy.defers(airing, new Event("press"))).isTrue();

        StateMachine changed = aired.withDeviceState(gap, "Open").withSends(gap, new Event("lock"));
        assertThat(changed.deviceState(gap)).isEqualTo("Open");
        assertThat(changed.sends(gap)).containsExactly(new Event("light"), new Event("beep"), new Event("lock"));
        assertThat(aired.deviceState(gap)).isEqualTo("StopUp");
    }

    @Test
    void refusesTwoDeviceStatesForOneState() {
        StateMachineBuilder builder = StateMachine.named("door")
                .initial("Gap")
                .deviceState("Gap", "StopUp")
                .deviceState("Gap", "StopUp");

        assertThat(builder.build().deviceState(new State("Gap"))).isEqualTo("StopUp");
        assertThatThrownBy(() -> builder.deviceState("Gap", "Open").build())
                .hasMessageContaining("state Gap has two device states, StopUp and Open; keep one");
        assertThatThrownBy(() -> builder.deviceState("Gap", " ")).isInstanceOf(ModelException.class);
    }

    @Test
    void aTransitionIsDrawnPartByPart() {
        StateMachine drawn = StateMachine.named("lamp")
                .initial("off")
                .from("off")
                .on("party")
                .when("dark")
                .to("wild")
                .effect("chime")
                .effect("flash")
                .on("press")
                .to("on")
                .from("wild")
                .on("party [late]")
                .stays()
                .and()
                .transition("wild", "stop", "off")
                .build();

        assertThat(drawn.transitions())
                .extracting(transition -> transition + " " + transition.effects() + " " + transition.internal())
                .containsExactly(
                        "off --party [dark]--> wild [chime, flash] false",
                        "off --press--> on [] false",
                        "wild --party [late]--> wild [] true",
                        "wild --stop--> off [] false");
    }

    @Test
    void whatIsMissingInADraftIsSaid() {
        StateMachineBuilder drafts = StateMachine.named("lamp")
                .initial("off")
                .from("off")
                .to("on")
                .from("on")
                .on("press")
                .and();
        assertThatThrownBy(drafts::build)
                .isInstanceOf(ModelException.class)
                .hasMessage("state machine 'lamp': the transition from off has no event; write on(...); "
                        + "the transition from on has no target; write to(...)");
    }

    @Test
    void aGuardIsNeverPartOfAnEventsName() {
        assertThat(StateMachine.named("lamp")
                        .initial("off")
                        .event("party [dark]")
                        .build()
                        .events())
                .containsExactly(new Event("party", List.of("dark")));
        assertThatThrownBy(StateMachine.named("lamp").initial("off").urgent("fire [hot]")::build)
                .hasMessageContaining("the event fire [hot] is declared with a guard; write fire, which holds for all");
    }
}
