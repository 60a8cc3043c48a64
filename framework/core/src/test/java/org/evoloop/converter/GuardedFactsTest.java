package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.converter.edge.EdgeShell;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** What the device does by itself, under guards that use the values of the event. */
class GuardedFactsTest {
    private static final StateMachine OVEN = machine(
            "oven",
            "Off press -> On",
            "On press -> Off",
            "On measured [hot] -> Off",
            "On measured -> On",
            "On light [dark] -> On");

    private final ManualClock clock = new ManualClock();
    private final Sensor sensor = new Sensor();

    private static final class Sensor extends PushMonitor {
        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("measured");
        }

        void measured(double celsius) {
            measured("celsius", celsius);
        }

        void measured(String what, double value) {
            push(fromDevice("measured", Values.of(what, value)));
        }
    }

    private static final StateMachine HALL =
            machine("hall", "Off press -> On", "On press -> Off", "Off measured [dark] -> On");

    private static final class Lamp extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("press");
        }

        @Override
        protected void send(Step step) {}
    }

    private static final class Oven extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("press", "light");
        }

        @Override
        protected void send(Step step) {}
    }

    private static final class Knowledge extends StateKnowledge {
        Knowledge() {
            super(new ModelPair(OVEN, OVEN));
        }

        @Override
        protected void registerNewFunctions() {
            guard("hot", values -> values.number("celsius") > 80);
            guard("dark", () -> true);
        }
    }

    @Test
    void theRecordFollowsByTheValuesAndNoOtherEventNeedsThem() throws InterruptedException {
        try (SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("oven", clock).withoutThreads())) {
            converter.addMonitor(sensor);
            converter.addExecute(new Oven());
            converter.addKnowledge(new Knowledge());
            converter.build();
            converter.start();
            sensor.press("press");
            sensor.measured(60);
            assertThat(after(converter)).isEqualTo("(On, On)");
            sensor.measured(90);
            assertThat(after(converter)).isEqualTo("(Off, Off)");
            assertThat(converter.status().faults()).isEmpty();
        }
    }

    @Test
    void whatTheDeviceDidBeforeTheConverterWasBuiltMovesTheRecordByItsGuardsToo() throws InterruptedException {
        ModelPair lit = new ModelPair(HALL, HALL);
        try (SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("hall", clock).withoutThreads())) {
            converter.addMonitor(sensor);
            converter.addExecute(new Lamp());
            converter.addKnowledge(new StateKnowledge(lit) {
                @Override
                protected void registerNewFunctions() {
                    guard("dark", values -> values.number("lux") < 10);
                }
            });
            sensor.measured("lux", 5);
            converter.build();
            assertThat(after(converter)).isEqualTo("(On, Off)");
            converter.start();
            assertThat(after(converter)).isEqualTo("(On, On)");
            assertThat(converter.history().get(0).detail()).isEqualTo("measured (by the device)");
        }
    }

    private String after(SystemEventConverter converter) throws InterruptedException {
        converter.observe(sensor);
        while (converter.step()) {
            converter.observe(sensor);
        }
        return converter.knowledge().configuration().toString();
    }

    @Test
    void whoDecidesElsewhereHearsWhichGuardsHold() {
        List<Set<String>> holding = new ArrayList<>();
        EdgeShell.Decider decider = new EdgeShell.Decider() {
            @Override
            public void observed(Occurrence occurrence) {
                holding.add(((Occurrence.Heard) occurrence).holding());
            }

            @Override
            public void answered(long sequence, EdgeShell.Result result, String reason, Optional<State> state) {}
        };
        try (EdgeShell shell = new EdgeShell(LoopConfig.defaults("oven", clock), new Knowledge(), decider)) {
            shell.addMonitor(sensor);
            shell.addExecute(new Oven());
            shell.open();
            sensor.measured(60);
            sensor.measured(90);
        }
        assertThat(holding)
                .as("also those of what may be sent then")
                .containsExactly(Set.of("dark"), Set.of("dark", "hot"));
    }
}
