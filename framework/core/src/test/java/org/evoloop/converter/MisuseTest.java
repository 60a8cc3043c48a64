package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import org.assertj.core.api.AbstractThrowableAssert;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** Wrong configurations are refused when they are registered or built, and can be corrected afterwards. */
class MisuseTest {
    private final RecordingExecute device = new RecordingExecute("Device", "Clean", "Spot");
    private final PushMonitor panel = new PushMonitor("Panel");
    private final StateKnowledge knowledge = knowledge();

    private static StateKnowledge knowledge() {
        StateKnowledge knowledge = new StateKnowledge(PaperModels.cleaningRobot());
        knowledge.function("Move", NewFunction.none());
        knowledge.function("SpotWait", NewFunction.none());
        return knowledge;
    }

    private SystemEventConverter converter(String name, Clock clock) {
        return new SystemEventConverter(LoopConfig.defaults(name, clock).withoutThreads());
    }

    private SystemEventConverter first(Clock clock) {
        SystemEventConverter first = converter("first", clock);
        first.addMonitor(panel);
        first.addExecute(device);
        first.addKnowledge(knowledge);
        first.build();
        first.start();
        return first;
    }

    @Test
    void whatBelongsToOneConverterIsRefusedByAnotherAndStaysWithTheFirst() throws InterruptedException {
        ManualClock clock = new ManualClock();
        try (SystemEventConverter first = first(clock);
                SystemEventConverter second = converter("second", clock)) {
            second.addMonitor(panel);
            second.addExecute(device);
            second.addKnowledge(knowledge);
            assertThatThrownBy(second::build)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("converter second: its clock belongs to the converter first already; make one for each "
                            + "converter; StateKnowledge belongs to the converter first already; make one for each "
                            + "converter; Panel belongs to the converter first already; make one for each converter; "
                            + "Device belongs to the converter first already; make one for each converter");
            panel.press("Clean");
            first.observe(panel);
            assertThat(first.step()).isTrue();
            assertThat(first.knowledge().configuration()).isEqualTo(Robot.at("On", "On"));
        }
    }

    @Test
    void aComponentIsFreeWhenItWasRemovedExchangedOrItsConverterClosed() {
        try (SystemEventConverter second = converter("second", new ManualClock())) {
            second.addKnowledge(knowledge());
            second.addExecute(new RecordingExecute("Device", "Clean", "Spot"));
            second.build();
            try (SystemEventConverter first = first(new ManualClock())) {
                assertThatThrownBy(() -> second.addMonitor(panel))
                        .hasMessage("Panel belongs to the converter first already; make another one");
                assertThatThrownBy(() -> second.exchange("Device", device))
                        .hasMessage("Device belongs to the converter first already; make another one");
                first.remove("Panel");
                second.addMonitor(panel);
                second.remove("Panel");
                first.addMonitor(panel);
                first.exchange("Panel", new PushMonitor("Other"));
                second.addMonitor(panel);
            }
            second.exchange("Device", device);
            assertThat(second.status().components()).hasSize(4);
        }
    }

    @Test
    void aConverterThatWasClosedBeforeItWasBuiltIsNotBuilt() {
        SystemEventConverter converter = converter("robot", new ManualClock());
        converter.addKnowledge(knowledge);
        converter.addExecute(device);
        converter.close();
        assertThatThrownBy(converter::build)
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("converter robot has been closed");
    }

    @Test
    void twoExecutesForOneEventAreRefused() {
        SystemEventConverter converter = converter("robot", new ManualClock());
        converter.addKnowledge(knowledge);
        converter.addExecute(device);
        converter.addExecute(new RecordingExecute("Other", "Spot"));
        assertThatThrownBy(converter::build)
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("Device and Other can both send Spot; let one of them do it");
    }

    @Test
    void whatIsRegisteredTwiceIsRefused() {
        knowledge.function("Move", NewFunction.none());
        knowledge.timer("SpotWait", "timeout", Duration.ofSeconds(1));
        knowledge.timer("SpotWait", "timeout", Duration.ofSeconds(2));
        knowledge.putTransition("On", "Move", NewFunction.none(), "Spot");
        knowledge.putTransition("On", "Move", NewFunction.none(), "Spot");
        assertRefusedByBuild()
                .hasMessageContaining("a function is registered twice for Move; keep one")
                .hasMessageContaining("a timer is registered twice for timeout in SpotWait; keep one")
                .hasMessageContaining("an action is registered twice for On --Spot--> Move; keep one");
    }

    private AbstractThrowableAssert<?, ?> assertRefusedByBuild() {
        SystemEventConverter converter = converter("robot", new ManualClock());
        converter.addKnowledge(knowledge);
        converter.addExecute(device);
        return assertThatThrownBy(converter::build).isInstanceOf(ModelException.class);
    }

    @Test
    void aTimerThatNoClockCanCountIsRefused() {
        knowledge.timer("SpotWait", "timeout", Duration.ofSeconds(Long.MAX_VALUE));
        assertRefusedByBuild()
                .hasMessage("the timer that raises timeout in SpotWait has the delay PT2562047788015215H30M7S, "
                        + "allowed is 0 to 36500 days");
    }

    @Test
    void aComponentThatNamesNoEventsAtAllIsRefused() {

        SystemEventConverter converter = converter("robot", new ManualClock());
        converter.addKnowledge(knowledge);
        converter.addExecute(device);
        converter.addMonitor(new PushMonitor("Forgetful") {
            @Override
            @SuppressWarnings("NullAway")
            protected Set<String> spontaneousEvents() {
                return null;
            }
        });
        assertThatThrownBy(converter::build)
                .isInstanceOf(ModelException.class)
                .hasMessage("Forgetful.spontaneousEvents() is null; return Set.of() if there are none");
    }

    @Test
    @SuppressWarnings("NullAway")
    void nullIsNoAnswerToAQuestion() {
        EventExecute mute = new EventExecute("Mute") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("Clean");
            }

            @Override
            protected void send(Step step) {}

            @Override
            protected Optional<String> locate() {
                return null;
            }
        };
        assertThatThrownBy(() -> Friends.EXECUTE.of(mute).locate(State::new, true, cause -> {}))
                .hasMessage("locate() is null; return Optional.empty() if the device does not know it");
    }

    @Test
    @SuppressWarnings("NullAway")
    void nullIsRefusedWhereItIsGiven() {
        SystemEventConverter converter = converter("robot", new ManualClock());
        assertThatThrownBy(() -> new SystemEventConverter(null)).hasMessage("the converter's config is null");
        assertThatThrownBy(() -> LoopConfig.defaults("robot", null)).hasMessage("the clock of a loop is null");
        assertThatThrownBy(() -> converter.addMonitor(null)).hasMessage("the component is null");
        assertThatThrownBy(() -> converter.addExecute(null)).hasMessage("the component is null");
        assertThatThrownBy(() -> converter.addKnowledge(null)).hasMessage("the knowledge is null");
        assertThatThrownBy(() -> converter.addLink(null)).hasMessage("the link is null");
        assertThatThrownBy(() -> converter.addSpare("spare", null)).hasMessage("the spare spare is null");
        assertThatThrownBy(() -> new StateKnowledge(null)).hasMessage("the models are null");
        assertThatThrownBy(() -> knowledge.function("Move", null))
                .hasMessage("the function of Move is null; NewFunction.none() does nothing");
        assertThatThrownBy(() -> knowledge.function(null, NewFunction.none()))
                .hasMessage("the name of a state is null");
        assertThatThrownBy(() -> knowledge.timer("SpotWait", "timeout", null))
                .hasMessage("the delay of timeout in SpotWait is null");
        assertThatThrownBy(() -> knowledge.timer("SpotWait", null, Duration.ZERO))
                .hasMessage("the name of an event is null");
        assertThatThrownBy(() -> panel.press(null)).hasMessage("the name of an event is null");
        assertThatThrownBy(() -> panel.press(" "))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the event that is pressed has no name; press one of the models' events");
        converter.addSpare("spare", () -> null);
        converter.addKnowledge(knowledge);
        converter.addExecute(device);
        assertThatThrownBy(() -> converter.knowledgeOf(null)).hasMessage("the models are null");
        converter.build();
        assertThatThrownBy(() -> converter.evolve(null)).hasMessage("the evolution is null");
        assertThatThrownBy(() -> converter.shadow(null)).hasMessage("the evolution is null");
        assertThatThrownBy(() -> converter.exchange("Device", "spare")).hasMessage("the spare spare is null");
        assertThatThrownBy(() -> converter.offer(null)).hasMessage("the occurrence is null");
        assertThatThrownBy(() -> panel.press("Clean", null))
                .hasMessage("the values of an event are null; Values.NONE are none");
        assertThatThrownBy(() -> panel.fromDevice("Clean", null))
                .hasMessage("the values of an event are null; Values.NONE are none");
        assertThatThrownBy(() -> new Occurrence.Heard(new Event("Clean"), null, Source.CONTROLLER, 0, 0))
                .hasMessage("the values of an event are null; Values.NONE are none");
        assertThatThrownBy(() -> new Occurrence.Heard(new Event("Clean"), Values.NONE, null, 0, 0))
                .hasMessage("the source of an event is null");
        assertThatThrownBy(() -> new Occurrence.Asked(new Event("Clean"), null, 0, 0))
                .hasMessage("the values of an event are null; Values.NONE are none");
        assertThatThrownBy(() -> new Occurrence.Found(null, 0))
                .hasMessage("the state in which the device was found is null");
        assertThatThrownBy(() -> converter.addSpare("spare", () -> panel))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("there is a spare named spare already");
    }
}
