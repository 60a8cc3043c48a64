package org.evoloop.payload;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.testkit.SimulatedDevice;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A function whose program is this test. */
class RemoteFunctionTest {
    private static final StateMachine LAMP = StateMachine.named("lamp")
            .initial("Off")
            .transition("Off", "power", "On")
            .transition("On", "power", "Off")
            .transition("Off", "dim", "On")
            .build();

    private static final StateMachine BLINKING = StateMachine.named("blinking")
            .initial("Off")
            .transition("Off", "power", "On")
            .transition("On", "power", "Off")
            .transition("Off", "blink", "Blink")
            .transition("Blink", "blink", "Off")
            .transition("Off", "dim", "On")
            .transition("Blink", "tired", "Off")
            .build();

    private final Wire wire = new Wire();
    private final ConverterHarness lamp = ConverterHarness.of(new StateKnowledge(new ModelPair(LAMP, BLINKING)) {
                @Override
                protected void registerNewFunctions() {
                    function("Blink", new RemoteFunction(wire));
                    sends("Blink", "power");
                }
            })
            .with(SimulatedDevice.of(LAMP).sends("power", "dim").build())
            .start();

    private static final class Wire implements RemoteFunction.Channel {
        private final List<String> told = new ArrayList<>();
        private final List<RemoteFunction.Listener> listeners = new ArrayList<>();
        private boolean isUp = true;

        @Override
        public boolean isUp() {
            return isUp;
        }

        @Override
        public String tell(String verb, String json) {
            if (!isUp) {
                return "there is no program";
            }
            told.add(json);
            return "";
        }

        @Override
        public void listen(RemoteFunction.Listener listener) {
            listeners.add(listener);
        }

        @Override
        public String toString() {
            return "the program";
        }
    }

    @AfterEach
    void close() {
        lamp.close();
    }

    private void says(String json) {
        wire.listeners.forEach(each -> each.heard("", json));
        lamp.advance(Duration.ZERO);
    }

    private void goes() {
        wire.isUp = false;
        wire.listeners.forEach(each -> each.lost("the program has ended with status 1"));
        lamp.advance(Duration.ZERO);
    }

    private String trouble() {
        return lamp.status().toString();
    }

    @Test
    void aProgramIsToldOfAVisitAndSaysWhatToDo() {
        lamp.press("blink", new Values(Map.of("times", 3)));
        assertThat(wire.told)
                .containsExactly(
                        "{\"do\":\"start\",\"visit\":2,\"state\":\"Blink\",\"device\":\"Off\",\"beginning\":\"new\","
                                + "\"values\":{\"times\":3.0}}");
        says("{\"do\":\"send\",\"visit\":2,\"event\":\"power\"}");
        assertThat(lamp.sent()).containsExactly("power");
        lamp.expect("On", "Blink");
        says("{\"do\":\"progress\",\"visit\":2,\"text\":\"once\",\"readings\":{\"left\":2}}");
        assertThat(trouble()).contains("once", "left");
        says("{\"do\":\"say\",\"visit\":2,\"text\":\"a bright light\"}");
        assertThat(lamp.transcript()).anyMatch(line -> line.contains("a bright light"));
        says("{\"do\":\"finish\",\"visit\":2,\"event\":\"tired\"}");
        lamp.expect("Off", "Off");
        assertThat(wire.told.get(1)).isEqualTo("{\"do\":\"stop\",\"visit\":2,\"state\":\"Blink\"}");
        assertThat(wire.told).hasSize(2);
    }

    @Test
    void whatIsSaidOfAVisitThatIsOverDoesNothing() {
        lamp.press("blink").press("blink").press("blink");
        says("{\"do\":\"finish\",\"visit\":2,\"event\":\"tired\"}");
        says("{\"do\":\"send\",\"visit\":2,\"event\":\"power\"}");
        lamp.expect("Off", "Blink");
        assertThat(lamp.sent()).isEmpty();
        lamp.press("blink");
        says("{\"do\":\"raise\",\"visit\":4,\"event\":\"tired\"}");
        lamp.expect("Off", "Off");
        assertThat(lamp.failures()).isEmpty();
    }

    @Test
    void aProgramThatIsLostInTheMiddleHasFailedAndStartsWithTheNextVisit() {
        lamp.press("blink");
        goes();
        assertThat(trouble()).contains("ended in the middle of the visit: the program has ended with status 1");
        wire.isUp = true;
        lamp.advance(Duration.ofSeconds(1));
        assertThat(wire.told).hasSize(2).last().asString().contains("stop");
        says("{\"do\":\"finish\",\"visit\":2,\"event\":\"tired\"}");
        lamp.expect("Off", "Blink");
        lamp.press("blink").press("blink");
        assertThat(wire.told).hasSize(3).last().asString().contains("start");
    }

    @Test
    void aVisitBeginsWhenTheProgramIsThere() {
        wire.isUp = false;
        lamp.press("blink").advance(Duration.ofSeconds(3));
        assertThat(trouble()).contains("waits for the program");
        goes();
        wire.isUp = true;
        lamp.advance(Duration.ofSeconds(1));
        assertThat(wire.told).hasSize(1).last().asString().contains("start");
        says("{\"do\":\"fail\",\"text\":\"killed\"}");
        assertThat(trouble()).contains("killed");
    }

    @Test
    void whatCannotBeUnderstoodIsTheFunctionsFailure() {
        lamp.press("blink");
        says("{\"visit\":");
        assertThat(trouble()).contains("it is not valid JSON");
        says("{\"do\":\"sing\",\"visit\":2}");
        assertThat(trouble()).contains("'sing' is none of send, raise");
        says("{\"do\":\"raise\",\"visit\":2,\"event\":\"bored\"}");
        assertThat(trouble()).contains("no transition for 'bored' in Blink");
        says("{\"do\":\"send\",\"visit\":2,\"event\":7}");
        assertThat(trouble()).contains("'event' must be a string");
        says("{\"temperature\":20}");
        says("{\"do\":\"fail\",\"visit\":2,\"text\":\"burnt out\"}");
        assertThat(trouble()).contains("burnt out");
        says("{\"do\":\"finish\",\"visit\":2,\"event\":\"tired\"}");
        lamp.expect("Off", "Blink");
    }

    @Test
    void onlyWhatTheStateDeclaresIsSent() {
        lamp.press("blink");
        says("{\"do\":\"send\",\"visit\":2,\"event\":\"dim\"}");
        assertThat(lamp.sent()).isEmpty();
        lamp.expect("Off", "Blink");
        assertThat(lamp.history()).last().asString().contains("FAILED", "the function of Blink asks for dim");
    }

    @Test
    void aProgramThatNeverStopsTalkingHasFailed() {
        lamp.press("blink");
        for (int each = 0; each < 10_001; each++) {
            wire.listeners.get(0).heard("say", "{\"visit\":2,\"text\":\"\"}");
        }
        assertThat(trouble()).contains("says more than can be done");
    }
}
