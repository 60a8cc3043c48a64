package org.evoloop.learn;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.learn.LearnedDevice.DisturbedException;
import org.evoloop.learn.LearnedDevice.LostException;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.testkit.Incident;
import org.evoloop.testkit.SimulatedDevice;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A simulated kettle behind a running converter that assumes nothing of it. */
class ConverterDeviceTest {
    private static final Duration SETTLE = Duration.ofMillis(5);
    private static final StateMachine KETTLE = StateMachine.named("kettle")
            .initial("Off")
            .transition("Off", "power", "Warm")
            .transition("Warm", "power", "Off")
            .transition("Warm", "boil", "Hot")
            .transition("Hot", "power", "Off")
            .transition("Hot", "done", "Off")
            .spontaneous("done")
            .build();

    private final SystemClock clock = new SystemClock();
    private final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("kettle", clock));
    private final PushMonitor buttons = new PushMonitor("Learner");
    private final PushMonitor wall = new PushMonitor("Wall");
    private final SimulatedDevice kettle = SimulatedDevice.of(KETTLE)
            .sends("power", "boil")
            .buttons("done")
            .answersLocate()
            .build();

    @BeforeEach
    void run() {
        converter.addMonitor(wall);
        run(converter, buttons, kettle);
    }

    private void run(SystemEventConverter converter, PushMonitor buttons, SimulatedDevice kettle) {
        StateMachineBuilder free = StateMachine.named("original").initial("Off");
        for (String state : List.of("Off", "Warm", "Hot")) {
            for (String event : List.of("power", "boil", "done", LookExecute.LOOK, LookExecute.SEEN)) {
                free.transition(state, event, state);
            }
        }
        StateMachine any = free.spontaneous("done").build();
        converter.addMonitor(buttons);
        converter.addExecute(new LookExecute());
        kettle.addTo(converter, converter.clock());
        converter.addKnowledge(new StateKnowledge(new ModelPair(any, any.withName("new"))));
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        converter.close();
        clock.close();
    }

    private ConverterDevice device(String home, String... resets) {
        return device(new WayHome(home, List.of(resets), Map.of(), Duration.ZERO));
    }

    private ConverterDevice device(WayHome way) {
        return new ConverterDevice(converter, buttons, LearnRules.NONE, way, SETTLE);
    }

    @Test
    void itIsLearnedThroughTheConverter() {
        Learned learned = new Learner(
                        device("Off", "power"),
                        List.of("boil", "power"),
                        LearnRules.NONE,
                        new LearnSettings(Duration.ofMillis(20), Duration.ofMinutes(5), 1),
                        clock,
                        null,
                        null,
                        (soFar, expected) -> {})
                .learn();

        assertThat(learned.open()).isEmpty();
        assertThat(learned.model("kettle").transitions())
                .extracting(Object::toString)
                .containsExactlyInAnyOrder(
                        "Off --power--> Warm", "Warm --power--> Off", "Warm --boil--> Hot", "Hot --power--> Off");
    }

    @Test
    void whatTheDeviceDoesEndsAWaitAndDisturbsAPress() throws InterruptedException {
        ConverterDevice device = device("Off", "power");
        device.reset();
        device.press("power");
        assertThat(device.press("boil").shown()).isEqualTo("Hot");
        assertThat(device.sent()).isEqualTo(2);

        kettle.actsAfter(Duration.ofMillis(50), "done");
        Heard heard = device.await(Duration.ofSeconds(20));

        assertThat(heard.acts()).containsExactly("done");
        assertThat(heard.shown()).isEqualTo("Off");
        assertThat(heard.after()).isGreaterThan(Duration.ofMillis(40));
        assertThat(device.await(Duration.ofMillis(20)).reply()).isEqualTo(Heard.Reply.SILENT);
    }

    @Test
    void whatTheDeviceRefusesDoesNotChangeHowLongItHasBeenAsItIs() throws InterruptedException {
        ConverterDevice device = device("Off", "power");
        device.reset();
        device.press("power");
        device.press("boil");
        long hot = clock.nanoTime();
        kettle.incidents((number, event) -> List.of(Incident.refused()));
        for (int i = 0; i < 10; i++) {
            assertThat(device.press("power").reply()).isEqualTo(Heard.Reply.REFUSED);
        }
        long refused = clock.nanoTime();

        kettle.actsAfter(Duration.ofMillis(1), "done");

        assertThat(device.await(Duration.ofSeconds(20)).after()).isGreaterThan(Duration.ofNanos(refused - hot));
    }

    @Test
    void theTimeInAStateBeginsWithThePressThatLedThere() throws InterruptedException {
        Duration settle = Duration.ofMillis(200);
        WayHome way = new WayHome("Off", List.of("power"), Map.of(), Duration.ZERO);
        ConverterDevice device = new ConverterDevice(converter, buttons, LearnRules.NONE, way, settle);
        device.reset();
        device.press("power");

        // It goes off without a word.
        kettle.put("Off");

        assertThat(device.await(Duration.ofSeconds(20)).after()).isGreaterThan(settle.dividedBy(2));
    }

    @Test
    void aPressAtItsControllerIsAPersons() throws InterruptedException {
        ConverterDevice device = device("Off", "power");
        device.reset();
        device.press("power");

        wall.press("boil");

        assertThatThrownBy(() -> device.await(Duration.ofSeconds(20)))
                .isInstanceOf(DisturbedException.class)
                .hasMessage("somebody pressed boil");
        assertThat(device.reset().shown()).isEqualTo("Off");
    }

    @Test
    void aResetSendsNothingThatARuleForbids() throws InterruptedException {
        LearnRules rules =
                new LearnRules(Set.of(), Map.of("Warm", Set.of("power")), Integer.MAX_VALUE, List.of(), null);
        WayHome way = new WayHome("Off", List.of("power", "boil"), Map.of(), Duration.ZERO);
        ConverterDevice device = new ConverterDevice(converter, buttons, rules, way, SETTLE);
        device.reset();
        device.press("power");

        assertThat(device.reset().shown()).isEqualTo("Off");
        assertThat(kettle.received()).containsExactly("power", "boil", "power");
    }

    @Test
    void whereAResetDoesNotLeadHomeAPersonIsAsked() throws InterruptedException {
        assertThat(device("Off", "power").reset().shown()).isEqualTo("Off");
        assertThatThrownBy(() -> device("Hot", "power").reset())
                .isInstanceOf(LostException.class)
                .hasMessageContaining("could not be brought to Hot by power");
        assertThat(device("", "power").reset().shown()).isNotEmpty();
    }

    @Test
    void aResetWaitsUntilTheDeviceHasArrived() throws InterruptedException {
        ConverterDevice device =
                device(new WayHome("Off", List.of(), Map.of("Warm", List.of("boil")), Duration.ofMinutes(1)));
        device.reset();
        device.press("power");
        kettle.incidents((number, event) -> {
            kettle.actsAfter(Duration.ofMillis(100), "done");
            return List.of();
        });

        assertThat(device.reset().shown()).isEqualTo("Off");
        assertThat(kettle.received()).containsExactly("power", "boil");
    }

    @Test
    void aDeviceThatDoesNotArriveInTimeIsNotWaitedForForEver() throws InterruptedException {
        ConverterDevice device =
                device(new WayHome("Off", List.of(), Map.of("Warm", List.of("boil")), Duration.ofMillis(50)));
        device.reset();
        device.press("power");

        assertThatThrownBy(device::reset)
                .isInstanceOf(LostException.class)
                .hasMessageContaining("could not be brought to Off by boil; it is in Hot");
    }

    @Test
    @Timeout(20)
    void aDeviceThatCannotBeAskedIsWhereItReportedLast() throws InterruptedException {
        SimulatedDevice mute = SimulatedDevice.of(KETTLE)
                .sends("power", "boil")
                .buttons("done")
                .build();
        try (SystemClock time = new SystemClock();
                SystemEventConverter own = new SystemEventConverter(LoopConfig.defaults("mute", time))) {
            PushMonitor presses = new PushMonitor("Learner");
            run(own, presses, mute);
            WayHome way = new WayHome("Off", List.of("power"), Map.of(), Duration.ZERO);
            ConverterDevice device = new ConverterDevice(own, presses, LearnRules.NONE, way, SETTLE);
            mute.reportsState();

            assertThat(device.reset().shown()).isEqualTo("Off");
            assertThat(device.press("power").reply()).isEqualTo(Heard.Reply.ACCEPTED);
            mute.reportsState();

            assertThat(device.await(Duration.ofSeconds(5)).shown()).isEqualTo("Warm");
        }
    }

    /** A contact at the kettle. */
    private static final class Contact extends PushMonitor {
        void tells(String state, long nanos) {
            push(new Occurrence.Found(new State(state), nanos));
        }
    }

    @Test
    @Timeout(20)
    void anEventDuringWhichTheDeviceReportsIsSentOnceAndIsNoAnswer() throws InterruptedException {
        try (SystemClock time = new SystemClock();
                SystemEventConverter own = new SystemEventConverter(LoopConfig.defaults("kettle", time))) {
            PushMonitor presses = new PushMonitor("Learner");
            Contact contact = new Contact();
            own.addMonitor(contact);
            own.addAnalyze(new OnceAnalyze());
            SimulatedDevice early = SimulatedDevice.of(KETTLE)
                    .sends("power", "boil")
                    .buttons("done")
                    .answersLocate()
                    .build();
            run(own, presses, early);
            ConverterDevice device = new ConverterDevice(
                    own,
                    presses,
                    LearnRules.NONE,
                    new WayHome("Off", List.of("power"), Map.of(), Duration.ZERO),
                    SETTLE);
            device.reset();
            early.incidents((number, event) -> {
                contact.tells("Warm", time.nanoTime());
                while (!own.status().states().original().name().equals("Warm")) {
                    Thread.onSpinWait();
                }
                return List.of();
            });

            assertThatThrownBy(() -> device.press("power"))
                    .isInstanceOf(DisturbedException.class)
                    .hasMessageContaining("while it was being sent");
            assertThat(early.received()).containsExactly("power");
        }
    }

    @Test
    void anEventThatIsNotTakenIsNoAnswer() {
        converter.stop();

        assertThatThrownBy(() -> device("", "power").press("power")).isInstanceOf(DisturbedException.class);
    }
}
