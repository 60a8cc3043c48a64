package org.evoloop.converter.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.LoggedLines;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the transcript says, and when. */
class TranscriptTest {
    private final LoggedLines transcript = new LoggedLines(Transcript.LOGGER);
    private final List<String> saidBeforeTheCommandLeft = new ArrayList<>();
    private final PushMonitor panel = new PushMonitor();
    private final SystemEventConverter converter = new SystemEventConverter(
            LoopConfig.defaults("robot", new ManualClock()).withoutThreads());

    @AfterEach
    void close() {
        converter.close();
        transcript.close();
    }

    @Test
    void nothingDelaysACommand() throws InterruptedException {
        converter.addMonitor(panel);
        converter.addExecute(new EventExecute("Device") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("Clean", "Spot");
            }

            @Override
            protected void send(Step step) {
                saidBeforeTheCommandLeft.addAll(transcript.lines());
            }
        });
        converter.addKnowledge(new StateKnowledge(PaperModels.cleaningRobot()) {
            @Override
            protected void registerNewFunctions() {
                function("Move", NewFunction.none());
                function("SpotWait", NewFunction.none());
            }
        });
        converter.build();
        converter.start();
        panel.press("Clean");
        converter.observe(panel);
        converter.step();
        assertThat(saidBeforeTheCommandLeft).isEmpty();
        assertThat(transcript.lines())
                .startsWith("----   button_event : Clean   -----")
                .contains(" Clean command")
                .endsWith(" original_current_state: On", " new_current_state: On");
        assertThat(transcript.keys()).containsOnly("[converter=\"robot\", event=\"Clean\"]");
    }

    @Test
    void noNameForgesALine() throws InterruptedException {
        converter.addMonitor(panel);
        converter.addExecute(new RecordingExecute("Device", "press\n forged command"));
        converter.addKnowledge(new StateKnowledge(new ModelPair(lamp("device"), lamp("lamp"))));
        converter.build();
        converter.start();
        panel.press("press\n forged command");
        converter.observe(panel);
        converter.step();

        assertThat(transcript.lines())
                .contains(" press? forged command command", " new_current_state: On?Off?")
                .noneMatch(line -> line.contains("\n") || line.contains("\u2028"));
    }

    private static StateMachine lamp(String name) {
        return StateMachine.named(name)
                .initial("Off")
                .transition("Off", "press\n forged command", "On\rOff\u2028")
                .build();
    }
}
