package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.time.Duration;
import java.util.Set;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** A kettle: what a person presses, among all that its models know. */
class ControllerEventsTest {
    private static final ModelPair MODELS = new ModelPair(
            machine(
                    "original",
                    "Off switch -> Heating",
                    "Heating switch -> Off",
                    "Heating boils -> Off",
                    "Off lamp => Off"),
            machine(
                    "new",
                    "Off switch [full] -> Heating",
                    "Off tea -> Brewing",
                    "Heating switch -> Off",
                    "Heating boils -> Off",
                    "Heating tooLong -> Off",
                    "Heating tm(5min) -> Off",
                    "Brewing steeped -> Off",
                    "Brewing lift -> Off",
                    "Brewing lamp => Brewing"));

    @Test
    void noTimerNoEventOfTheDeviceAndNoneOfAFunctionIsAmongThemUnlessAMonitorReportsIt() {
        try (ManualClock clock = new ManualClock();
                SystemEventConverter converter = new SystemEventConverter(
                        LoopConfig.defaults("kettle", clock).withoutThreads())) {
            converter.addMonitor(new PushMonitor("Panel") {
                @Override
                protected Set<String> spontaneousEvents() {
                    return Set.of("boils");
                }
            });
            converter.addMonitor(new PushMonitor("Lid") {
                @Override
                protected Set<String> controllerEvents() {
                    return Set.of("lift", "boils", "tm(5min)", "of another model");
                }
            });
            converter.addExecute(new RecordingExecute("Kettle", "switch", "lamp"));
            converter.addKnowledge(new StateKnowledge(MODELS) {
                @Override
                protected void registerNewFunctions() {
                    function("Brewing", NewFunction.none());
                    timer("Heating", "tooLong", Duration.ofMinutes(4));
                    guard("full", () -> true);
                }
            });
            converter.build();

            assertThat(converter.controllerEvents())
                    .containsExactly(new Event("lamp"), new Event("lift"), new Event("switch"), new Event("tea"));
            converter.remove("Lid");
            assertThat(converter.controllerEvents()).doesNotContain(new Event("lift"));
        }
    }
}
