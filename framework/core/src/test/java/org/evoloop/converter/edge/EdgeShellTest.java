package org.evoloop.converter.edge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.evoloop.PaperModels;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The components of a lamp's converter, with the test in place of the core. */
class EdgeShellTest {
    private final List<String> reports = new CopyOnWriteArrayList<>();
    private final List<String> done = new CopyOnWriteArrayList<>();
    private final ManualClock clock = new ManualClock();
    private final Panel panel = new Panel();
    private final Bulb bulb = new Bulb();
    private EdgeShell shell;

    private static final class Panel extends PushMonitor {
        void switched() {
            push(fromPanel("switch", true));
        }
    }

    private final class Bulb extends EventExecute {
        private Exception failure;

        @Override
        protected Set<String> sendableEvents() {
            return Set.of("switch");
        }

        @Override
        protected void send(Step step) throws Exception {
            done.add(step.source() + " " + step.trigger());
            if (failure != null) {
                throw failure;
            }
            tookEffect();
            panel.switched();
        }

        @Override
        protected Optional<String> locate() {
            return Optional.of("on");
        }

        @Override
        protected void settled(Configuration now) {
            done.add("settled in " + now.original());
        }

        @Override
        protected void released() {
            done.add("released");
        }
    }

    private static final class Knowledge extends StateKnowledge {
        private final NewFunction waiting;

        Knowledge(NewFunction waiting) {
            super(PaperModels.lightBulb());
            this.waiting = waiting;
        }

        @Override
        protected void registerNewFunctions() {
            function("wait", waiting);
            function("incandescentOn", NewFunction.none());
        }
    }

    @BeforeEach
    void open() {
        NewFunction waiting = visit -> {
            done.add("waiting in " + visit.number());
            visit.onEnd(() -> done.add("over"));
            visit.raise("timeout");
            visit.send("switch");
            visit.awaitEnd();
        };
        shell = new EdgeShell(LoopConfig.defaults("lamp", clock), new Knowledge(waiting), new EdgeShell.Decider() {
            @Override
            public void observed(Occurrence occurrence) {
                reports.add(occurrence + " in " + occurrence.visit());
            }

            @Override
            public void answered(long sequence, EdgeShell.Result result, String reason, Optional<State> state) {
                reports.add(sequence + " " + result + reason
                        + state.map(found -> " " + found).orElse(""));
            }
        });
        shell.addMonitor(panel);
        shell.addExecute(bulb);
        shell.open();
    }

    @AfterEach
    void close() {
        shell.close();
        clock.close();
    }

    private static Step step(String event) {
        Event taken = new Event(event);
        return new Step(new Transition(new State("off"), taken, new State("on")), taken, false, false);
    }

    private void stand(String device, String system, long visit, boolean settled, boolean function) {
        Configuration at = new Configuration(new State(device), new State(system));
        shell.stand(new EdgeShell.Standing(at, visit, settled, function, "on", "switch"));
    }

    @Test
    void effectsAndFactsAreReportedInTheOrderOfTheDevice() throws Exception {
        panel.switched();
        shell.send(7, step("switch"), Values.NONE);
        assertThat(done).containsExactly("off switch");
        assertThat(reports)
                .containsExactly(
                        "switch (panel, the device acted) in 0", "7 SENT", "switch (panel, the device acted) in 0");
    }

    @Test
    void whatCannotBeDoneIsAnsweredOnce() throws Exception {
        bulb.failure = new IllegalStateException("no bulb");
        shell.send(1, step("switch"), Values.NONE);
        bulb.failure = new UnknownEffectException("no answer");
        shell.send(2, step("switch"), Values.NONE);
        shell.send(3, step("dim"), Values.NONE);
        shell.run(4, "ring", Values.NONE);
        shell.locate(5);
        assertThat(reports)
                .containsExactly(
                        "1 FAILEDBulb.send: no bulb",
                        "2 IN_DOUBTBulb.send: no answer",
                        "3 FAILEDnothing here can send dim",
                        "4 FAILEDeffect.ring: nothing is bound to it; call effect in registerNewFunctions",
                        "5 SENT on");
    }

    @Test
    void aFunctionRunsWhileItsVisitLastsAndBelongsToIt() {
        stand("on", "wait", 3, true, true);
        Awaitility.await().until(() -> reports.size() == 2);
        assertThat(reports).containsExactly("timeout (function) in 3", "switch (asked by a function) in 3");
        assertThat(done).containsExactly("settled in on", "waiting in 3");
        // Repeating it changes nothing; a function that has ended is not started again.
        stand("on", "wait", 3, false, true);
        assertThat(done).hasSize(2);
        shell.leave(3);
        assertThat(done).endsWith("over");
        stand("on", "wait", 3, false, true);
        assertThat(done).hasSize(3);
        stand("off", "off", 4, true, false);
        assertThat(done).endsWith("settled in off");
    }

    @Test
    void aFunctionWhoseStartHasToWaitBeginsLaterInTheSameVisit() {
        stand("on", "wait", 3, true, true);
        Awaitility.await().until(() -> reports.size() == 2);
        stand("on", "wait", 4, false, false);
        assertThat(done).endsWith("over");
        stand("on", "wait", 4, true, true);
        Awaitility.await().until(() -> done.contains("waiting in 4"));
    }

    @Test
    void aVisitThatIsOverBeforeItIsReceivedDoesNotBegin() {
        shell.leave(5);
        stand("on", "wait", 5, true, true);
        assertThat(done).containsExactly("settled in on");
        shell.close();
        assertThat(done).endsWith("released");
    }

    @Test
    void aStateThatTheModelsDoNotHaveIsLeftAlone() {
        stand("on", "strobe", 2, true, true);
        assertThat(done).isEmpty();
    }

    @Test
    void modelsThatDoNotFitAreRefused() {
        EdgeShell wrong = new EdgeShell(
                LoopConfig.defaults("wrong", clock),
                new StateKnowledge(PaperModels.lightBulb()),
                new EdgeShell.Decider() {
                    @Override
                    public void observed(Occurrence occurrence) {}

                    @Override
                    public void answered(
                            long sequence, EdgeShell.Result result, String reason, Optional<State> state) {}
                });
        assertThatThrownBy(wrong::open)
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("new state wait has no function");
    }
}
