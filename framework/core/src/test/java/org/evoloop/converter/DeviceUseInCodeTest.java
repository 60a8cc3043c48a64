package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.function.Consumer;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** Device states and sends that are registered in code instead of drawn. */
class DeviceUseInCodeTest {
    private static final State BOOST = new State("Boost");

    private static final class Known extends StateKnowledge {
        private final Consumer<Known> more;

        Known(Consumer<Known> more, String... drawn) {
            super(new ModelPair(
                    machine("air", "Cool turbo -> Turbo", "Turbo turbo -> Cool", "Cool swing -> Cool"),
                    machine(
                            "boost",
                            "Cool turbo -> Turbo",
                            "Turbo turbo -> Cool",
                            "Cool swing -> Cool",
                            "Cool boost -> Boost",
                            drawn.length > 0 ? drawn[0] : "Boost boost -> Cool")));
            this.more = more;
        }

        @Override
        protected void registerNewFunctions() {
            function("Boost", NewFunction.none());
            more.accept(this);
        }

        Known registered() {
            Friends.KNOWLEDGE.of(this).register();
            return this;
        }

        List<String> problems(boolean leftOver) {
            return Friends.KNOWLEDGE.of(this).problems(leftOver);
        }
    }

    @Test
    void meanTheSameAsThoseThatAreDrawn() {
        ModelPair models = new Known(known -> {
                    known.device("Boost", "Turbo");
                    known.sends("Boost", "swing");
                })
                .registered()
                .models();

        assertThat(models.whereDeviceMustBe(BOOST)).containsExactly(new State("Turbo"));
        assertThat(models.evolved().sends(BOOST)).containsExactly(new Event("swing"));
    }

    @Test
    void anotherDeviceStateThanTheDrawnOneIsAProblem() {
        Known known = new Known(each -> each.device("Boost", "Cool"), "Boost device Turbo").registered();

        assertThat(known.problems(true)).contains("state Boost has two device states, Turbo and Cool; keep one");
        assertThat(known.models().whereDeviceMustBe(BOOST)).containsExactly(new State("Turbo"));
    }

    @Test
    void aModelThatDrawsWhatAFunctionSendsDrawsAllOfIt() {
        Known same = new Known(each -> each.sends("Boost", "swing"), "Boost sends swing").registered();
        Known more = new Known(each -> each.sends("Boost", "turbo"), "Boost sends swing").registered();

        assertThat(same.problems(true)).noneMatch(problem -> problem.contains("sends"));
        assertThat(more.problems(true))
                .contains("the function of Boost sends turbo, but the new model draws that it sends swing only; draw"
                        + " turbo, too, or remove it from the code");
    }

    @Test
    void aMisspeltStateIsAProblem() {
        Known known = new Known(each -> each.sends("Bost", "swing")).registered();

        assertThat(known.problems(true))
                .contains("a use of the device is registered for Bost, which is not a state of the new model; did you"
                        + " mean Boost?");
        assertThat(known.problems(false)).isEmpty();
    }

    @Test
    void aDeviceStateThatTheDeviceLacksIsRefused() {
        Known known = new Known(each -> each.device("Boost", "Trubo"));

        assertThatThrownBy(known::registered)
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("did you mean Turbo?");
    }
}
