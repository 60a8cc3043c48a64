package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
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

    private final Lamp lamp = new Lamp();
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
        upper.addDevice(lower.asDevice());
        upper.addKnowledge(new Knowledge(new ModelPair(WARM, PARTY), "Blinking"));
        upper.build();
    }

    private static final class Lamp extends EventExecute {
        final List<String> sent = new CopyOnWriteArrayList<>();
        volatile boolean isLoose;

        @Override
        protected Set<String> sendableEvents() {
            return Set.of("switch");
        }

        @Override
        protected void send(Step step) {
            if (isLoose) {
                throw new IllegalStateException("the lamp is loose");
            }
            sent.add(step.trigger().name());
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

    /** Starts both; returns what ends in the upper one from now on. */
    private BlockingQueue<HistoryEntry> start() {
        BlockingQueue<HistoryEntry> ended = new LinkedBlockingQueue<>();
        upper.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                ended.add(entry);
            }
        });
        lower.start();
        upper.start();
        return ended;
    }

    private static HistoryEntry next(BlockingQueue<HistoryEntry> ended) throws InterruptedException {
        HistoryEntry entry = ended.poll(30, TimeUnit.SECONDS);
        assertThat(entry).isNotNull();
        return entry;
    }

    @Test
    void anEventOfTheUpperOneBecomesEventsOfTheLowerOneAndThoseOneOfTheDevice() throws InterruptedException {
        BlockingQueue<HistoryEntry> ended = start();
        remote.press("party");
        assertThat(next(ended).outcome()).isEqualTo(Outcome.HANDLED);

        assertThat(upper.knowledge().configuration()).hasToString("(Warm, Warm)");
        assertThat(lower.knowledge().configuration()).hasToString("(On, Warm)");
        assertThat(lamp.sent).containsExactly("switch");
    }

    @Test
    void whatTheLowerOneCannotDoFailsInTheUpperOne() throws InterruptedException {
        BlockingQueue<HistoryEntry> ended = start();
        lamp.isLoose = true;
        remote.press("party");
        HistoryEntry failed = next(ended);
        assertThat(failed.outcome()).isEqualTo(Outcome.FAILED);
        assertThat(failed.detail()).contains("lower did not obey").contains("the lamp is loose");
        assertThat(upper.knowledge().configuration()).hasToString("(Off, Off)");

        lower.stop();
        remote.press("switch");
        assertThat(next(ended).detail()).contains("lower does not take switch; is it started?");
    }

    @Test
    void whatTheLowerOneDoesByItselfMovesTheUpperOne() throws InterruptedException {
        BlockingQueue<HistoryEntry> ended = start();
        lowerEvents.press("switch");
        assertThat(next(ended).occurrence().label()).isEqualTo("found On");
        assertThat(upper.knowledge().configuration()).hasToString("(On, On)");

        remote.press("switch");
        next(ended);
        assertThat(upper.knowledge().configuration()).hasToString("(Off, Off)");
        assertThat(lower.knowledge().configuration()).hasToString("(Off, Off)");
        assertThat(lamp.sent).containsExactly("switch", "switch");
    }

    @Test
    void withoutThreadsTheUpperOneTakesTheStepsOfTheLowerOne() throws InterruptedException {
        PushMonitor control = new PushMonitor("Remote");
        PushMonitor own = new PushMonitor("Own");
        Lamp bulb = new Lamp();
        try (SystemEventConverter below = new SystemEventConverter(
                        LoopConfig.defaults("below", new ManualClock()).withoutThreads());
                SystemEventConverter above = new SystemEventConverter(
                        LoopConfig.defaults("above", new ManualClock()).withoutThreads())) {
            below.addMonitor(own);
            below.addExecute(bulb);
            below.addKnowledge(new Knowledge(new ModelPair(LAMP, WARM), "Warm"));
            below.build();
            above.addMonitor(control);
            above.addDevice(below.asDevice());
            above.addKnowledge(new Knowledge(new ModelPair(WARM, PARTY), "Blinking"));
            above.build();
            below.start();
            above.start();

            CompletableFuture<EventOutcome> party = control.submit("party");
            assertThat(above.step()).isTrue();
            assertThat(party.join()).hasToString("handled: Warm, sent switch, dim");
            assertThat(below.knowledge().configuration()).hasToString("(On, Warm)");

            own.press("switch");
            assertThat(below.step()).isTrue();
            assertThat(above.step()).isTrue();
            assertThat(above.knowledge().configuration()).hasToString("(Off, Off)");
            assertThat(bulb.sent).containsExactly("switch", "switch");
        }
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
