package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Two converters, one on top of the other, under one console: the new model of the lower one is the original model of
 * the upper one. The lower one adds a warm light to a lamp that only has a switch; the upper one adds a party.
 */
@Timeout(60)
class TwoConvertersTest {
    private static final StateMachine LAMP = machine("lamp", "Off switch -> On", "On switch -> Off");
    private static final StateMachine WARM =
            machine("warm", "Off switch -> On", "On switch -> Off", "On dim -> Warm", "Warm switch -> Off");
    private static final StateMachine PARTY = machine(
            "party",
            "Off switch -> On",
            "On switch -> Off",
            "On dim -> Warm",
            "Warm switch -> Off",
            "Off party -> Warm",
            "Warm boost -> Blinking",
            "Blinking switch -> Off");

    private final RecordingExecute lamp = new RecordingExecute("Lamp", "switch");
    private final PushMonitor lowerEvents = new PushMonitor("LowerEvents");
    private final PushMonitor remote = new PushMonitor("Remote");
    private final SystemClock lowerClock = new SystemClock();
    private final SystemClock upperClock = new SystemClock();
    private final SystemEventConverter lower = new SystemEventConverter(LoopConfig.defaults("lower", lowerClock));
    private final SystemEventConverter upper = new SystemEventConverter(LoopConfig.defaults("upper", upperClock));

    TwoConvertersTest() {
        lower.addMonitor(lowerEvents);
        lower.addExecute(lamp);
        lower.addKnowledge(new Knowledge(new ModelPair(LAMP, WARM), "Warm"));
        lower.build();

        upper.addMonitor(remote);
        upper.addExecute(new Lower());
        upper.addKnowledge(new Knowledge(new ModelPair(WARM, PARTY), "Blinking"));
        upper.build();
    }

    /** Sends events to the lower converter; they have taken effect when that converter has processed them. */
    private final class Lower extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("switch", "dim");
        }

        @Override
        protected void send(Step step) throws InterruptedException {
            CountDownLatch dealtWith = new CountDownLatch(1);
            lower.addListener(new ConverterListener() {
                @Override
                public void ended(HistoryEntry entry) {
                    dealtWith.countDown();
                }
            });
            lowerEvents.press(step.trigger().name());
            if (!dealtWith.await(30, TimeUnit.SECONDS)) {
                throw new IllegalStateException("the lower converter has not dealt with " + step.trigger());
            }
        }

        @Override
        protected Optional<String> locate() {
            return Optional.of(lower.knowledge().getCurrentState().name());
        }
    }

    private static final class Knowledge extends StateKnowledge {
        private final String added;

        Knowledge(ModelPair pair, String added) {
            super(pair);
            this.added = added;
        }

        @Override
        protected void registerNewFunctions() {
            function(added, NewFunction.none());
        }
    }

    @AfterEach
    void close() {
        upper.close();
        lower.close();
        upperClock.close();
        lowerClock.close();
    }

    @Test
    void anEventOfTheUpperOneBecomesEventsOfTheLowerOneAndThoseOneOfTheDevice() throws InterruptedException {
        CountDownLatch arrived = new CountDownLatch(1);
        upper.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                arrived.countDown();
            }
        });
        lower.start();
        upper.start();
        remote.press("party");
        assertThat(arrived.await(30, TimeUnit.SECONDS)).isTrue();

        assertThat(upper.knowledge().configuration()).hasToString("(Warm, Warm)");
        assertThat(lower.knowledge().configuration()).hasToString("(On, Warm)");
        assertThat(lamp.sent()).containsExactly("switch");
    }

    @Test
    void theFirstScreenShowsBothAndWhichIsToBeStarted() {
        assertThat(firstScreen())
                .contains("converter   upper, stopped", "converter   lower, stopped")
                .endsWith("Type start to convert events; help lists all commands.");
        upper.start();
        assertThat(firstScreen()).endsWith("Type lower start to convert events; help lists all commands.");
        lower.start();
        assertThat(firstScreen()).endsWith("Type press party; help lists all commands.");
    }

    private List<String> firstScreen() {
        ConsoleCommand press = ConsoleCommand.of("press EVENT", "", (arguments, out) -> {})
                .completing(before -> List.of("boost", "party"));
        return ConverterCommands.text(out -> FirstScreen.show(List.of(upper, lower), List.of(press), out))
                .lines()
                .toList();
    }

    @Test
    void oneConsoleControlsBothEachByItsName() {
        String lines = "lower start\nlower status\nstart\nstatus\nupper status\nlowr start\nlower stop now\n";
        Captured out = new Captured();
        Captured err = new Captured();
        Console console = new Console(
                upper, new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)), out.stream, err.stream);
        console.addConverter(lower);
        console.run();

        assertThat(out.lines())
                .contains("running: original Off, new Off")
                .contains("converter   lower, running", "converter   upper, running")
                .filteredOn(line -> line.startsWith("converter"))
                .hasSize(2);
        assertThat(err.lines())
                .containsExactly(
                        "error: unknown command 'upper'; help lists the commands",
                        "error: unknown command 'lowr'; did you mean lower?",
                        "error: usage: stop");
        assertThat(List.of(lower.status().loop(), upper.status().loop())).containsOnly(LoopState.EXITED);
    }
}
