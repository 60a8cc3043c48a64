package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;

/** The applications' models, element by element. */
class ModelFilesTest {
    private static final Path MODELS = Path.of(System.getProperty("evoloop.root"), "models");

    @Test
    void cleaningRobotOriginal() {
        assertMachine(
                "cleaning-robot.xml#original",
                "Off",
                List.of("Off", "On", "Clean", "Spot"),
                List.of("Clean", "Spot", "endSpot"),
                List.of(
                        "Off --Clean--> On",
                        "On --Clean--> Clean",
                        "On --Spot--> Spot",
                        "Clean --Clean--> On",
                        "Spot --endSpot--> On"));
    }

    @Test
    void cleaningRobotNew() {
        assertMachine(
                "cleaning-robot.xml#new",
                "Off",
                List.of("Off", "On", "Move", "Clean", "SpotWait", "Spot"),
                List.of("Clean", "Spot", "arriveSpot", "endSpot", "timeout"),
                List.of(
                        "Off --Clean--> On",
                        "On --Spot--> Move",
                        "On --Clean--> Clean",
                        "Move --arriveSpot--> Spot",
                        "Spot --endSpot--> On",
                        "Clean --Clean--> SpotWait",
                        "SpotWait --timeout--> On",
                        "SpotWait --Clean--> Spot"));
    }

    @Test
    void lightBulbOriginal() {
        assertMachine(
                "light-bulb.xml#original",
                "off",
                List.of("off", "on"),
                List.of("switch"),
                List.of("off --switch--> on", "on --switch--> off"));
    }

    @Test
    void lightBulbNew() {
        assertMachine(
                "light-bulb.xml#new",
                "off",
                List.of("off", "on", "wait", "incandescentOn"),
                List.of("switch", "timeout"),
                List.of(
                        "off --switch--> on",
                        "on --switch--> wait",
                        "wait --timeout--> off",
                        "wait --switch--> incandescentOn",
                        "incandescentOn --switch--> off"));
    }

    @Test
    void aMachineAnswersToItsDiagramNameItsOwnNameAndItsId() {
        ModelFile file = ModelFile.read(MODELS.resolve("cleaning-robot.xml"));

        assertThat(file.machines()).extracting(XmiMachine::name).containsExactly("original", "new");
        assertThat(file.machines())
                .extracting(XmiMachine::machineName)
                .containsExactly("StateMachine0", "StateMachine1");
        assertThat(file.pick("StateMachine1").states())
                .isEqualTo(file.pick("new").states());
        assertThat(file.pick(file.machines().get(1).id()).states())
                .isEqualTo(file.pick("new").states());
    }

    private static void assertMachine(
            String reference, String initial, List<String> states, List<String> events, List<String> transitions) {
        StateMachine machine = ModelFile.machine(MODELS.resolve(reference).toString());

        assertThat(machine.name()).isEqualTo(reference.substring(reference.indexOf('#') + 1));
        assertThat(machine.initial()).isEqualTo(new State(initial));
        assertThat(machine.states()).extracting(State::name).containsExactlyInAnyOrderElementsOf(states);
        assertThat(machine.events()).extracting(Event::name).containsExactlyInAnyOrderElementsOf(events);
        assertThat(machine.transitions())
                .extracting(Transition::toString)
                .containsExactlyInAnyOrderElementsOf(transitions);
    }
}
