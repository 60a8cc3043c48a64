package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.util.Set;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** An air conditioner: events are the device's own if they are declared so, not merely because they cannot be sent. */
class DevicesOwnTest {
    private static final String[] LINES = {
        "Off power -> Cool", "Cool power -> Off", "Cool temp-up -> Warm", "Warm temp-up -> Warm", "Warm cooled -> Cool"
    };
    private static final StateMachine DEVICE = machine("original", LINES);
    private static final String NOBODYS =
            "event %s of the original model can be sent by no execute component and is not "
                    + "declared to be the device's own; name it in sendableEvents, or in spontaneousEvents of a monitor";

    private final RecordingExecute infrared = new RecordingExecute("Infrared", "power", "temp-up");
    private final SystemEventConverter converter = new SystemEventConverter(
            LoopConfig.defaults("air", new ManualClock()).withoutThreads());
    private final Remote remote = new Remote("Remote", "cooled");

    private static final class Remote extends PushMonitor {
        private final Set<String> spontaneous;

        Remote(String name, String... spontaneous) {
            super(name);
            this.spontaneous = Set.of(spontaneous);
        }

        void done(String event) {
            push(fromDevice(event));
        }

        @Override
        protected Set<String> spontaneousEvents() {
            return spontaneous;
        }
    }

    private void build(StateMachine device, PushMonitor monitor, RecordingExecute sender) {
        converter.addMonitor(monitor);
        converter.addExecute(sender);
        converter.addKnowledge(new StateKnowledge(new ModelPair(device, machine("new", LINES))));
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        converter.close();
    }

    @Test
    void anEventThatIsNeitherSentNorDeclaredIsRefusedOnceByBuild() {
        assertThatThrownBy(() -> build(DEVICE, new Remote("Remote"), new RecordingExecute("Infrared", "power")))
                .isInstanceOf(ModelException.class)
                .hasMessage("the model 'new' cannot be carried out:\n  " + NOBODYS.formatted("temp-up") + "\n  "
                        + NOBODYS.formatted("cooled"));
    }

    @Test
    void byRemoveAndExchangeTooAndEverythingStaysAsItWas() throws InterruptedException {
        build(DEVICE, remote, infrared);
        assertThatThrownBy(() -> converter.exchange("Infrared", new RecordingExecute("Weak", "power")))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(NOBODYS.formatted("temp-up"));
        assertThatThrownBy(() -> converter.exchange("Remote", new Remote("Other")))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(NOBODYS.formatted("cooled"));
        assertThatThrownBy(() -> converter.remove("Remote"))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(NOBODYS.formatted("cooled"));
        press("power");
        press("temp-up");
        assertThat(infrared.sent()).containsExactly("power", "temp-up");
    }

    @Test
    void whatAMonitorDeclaresIsTakenForDoneAndNothingIsSent() throws InterruptedException {
        build(DEVICE, remote, infrared);
        press("power");
        press("temp-up");
        remote.done("cooled");
        convert();
        assertThat(converter.knowledge().configuration()).isEqualTo(Robot.at("Cool", "Cool"));
        assertThat(infrared.sent()).containsExactly("power", "temp-up");
    }

    @Test
    void whatTheModelDeclaresNeedsNoMonitor() throws InterruptedException {
        StateMachine declaring = StateMachine.named("original")
                .initial("Off")
                .transition("Off", "power", "Cool")
                .transition("Cool", "power", "Off")
                .transition("Cool", "temp-up", "Warm")
                .transition("Warm", "temp-up", "Warm")
                .transition("Warm", "cooled", "Cool")
                .spontaneous("cooled")
                .build();
        Remote plain = new Remote("Remote");
        build(declaring, plain, infrared);
        plain.press("power");
        plain.press("temp-up");
        plain.done("cooled");
        for (int event = 0; event < 3; event++) {
            converter.observe(plain);
            converter.step();
        }
        assertThat(converter.knowledge().configuration()).isEqualTo(Robot.at("Cool", "Cool"));
    }

    @Test
    void anEventMayBeTheDevicesOwnAndBeSentAsWell() throws InterruptedException {
        Remote buttons = new Remote("Buttons", "power", "cooled");
        build(DEVICE, buttons, infrared);
        buttons.press("power");
        converter.observe(buttons);
        converter.step();
        buttons.done("power");
        converter.observe(buttons);
        converter.step();
        assertThat(converter.knowledge().configuration()).isEqualTo(Robot.at("Off", "Off"));
        assertThat(infrared.sent()).containsExactly("power");
    }

    private void press(String event) throws InterruptedException {
        remote.press(event);
        convert();
    }

    private void convert() throws InterruptedException {
        converter.observe(remote);
        converter.step();
    }
}
