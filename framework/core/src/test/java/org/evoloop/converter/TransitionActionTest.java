package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Functions that are bound to one transition (the paper's {@code putTransition}), in a converter without threads. */
class TransitionActionTest {
    private final List<String> life = new ArrayList<>();
    private final Robot.Panel panel = new Robot.Panel();
    private final StateKnowledge knowledge = new StateKnowledge(PaperModels.cleaningRobot());
    private final SystemEventConverter converter = new SystemEventConverter(
            LoopConfig.defaults("robot", new ManualClock()).withoutThreads());
    private boolean cableIsOut;

    private NewFunction noting(String name) {
        return visit -> {
            life.add(name + " begins");
            visit.onEnd(() -> life.add(name + " ends"));
        };
    }

    @BeforeEach
    void build() {
        knowledge.putTransition("On", "Move", noting("drive"), "Spot");
        knowledge.function("SpotWait", noting("wait"));
        converter.addMonitor(panel);
        converter.addKnowledge(knowledge);
        converter.addExecute(new EventExecute("Device") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("Clean", "Spot");
            }

            @Override
            protected void send(Step step) throws IOException {
                if (cableIsOut) {
                    throw new IOException("the cable is out");
                }
            }
        });
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private void press(String... events) throws InterruptedException {
        for (String event : events) {
            panel.press(event);
            converter.observe(panel);
            converter.step();
        }
    }

    @Test
    void theActionRunsInPlaceOfTheTargetsFunction() throws InterruptedException {
        knowledge.putTransition("Clean", "SpotWait", noting("special wait"), "Clean");
        press("Clean", "Clean", "Clean", "Clean");
        assertThat(life).containsExactly("special wait begins", "special wait ends");
    }

    @Test
    void theActionIsBoundToItsTransition() {
        BoundTransition bound =
                knowledge.getTransition(new State("On"), new Event("Spot")).orElseThrow();
        assertThat(bound.target()).isEqualTo(new State("Move"));
        assertThat(knowledge.getTransition(new State("On"), new Event("endSpot")))
                .isEmpty();
    }

    @Test
    void theActionRunsAgainWhenItsStateCouldNotBeLeft() throws InterruptedException {
        press("Clean", "Spot");
        cableIsOut = true;
        press("arriveSpot");
        assertThat(converter.knowledge().configuration()).isEqualTo(at("On", "Move"));
        assertThat(life).containsExactly("drive begins", "drive ends", "drive begins");
    }

    @Test
    void theActionRunsAgainAfterStopAndStart() throws InterruptedException {
        press("Clean", "Spot");
        converter.stop();
        converter.start();
        assertThat(life).containsExactly("drive begins", "drive ends", "drive begins");
        press("arriveSpot");
        assertThat(converter.knowledge().configuration()).isEqualTo(at("Spot", "Spot"));
        assertThat(life).endsWith("drive ends");
    }
}
