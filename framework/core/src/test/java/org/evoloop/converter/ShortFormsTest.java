package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** A converter whose components are lambdas. */
class ShortFormsTest {
    private static final StateMachine LAMP = StateMachine.named("lamp")
            .initial("off")
            .from("off")
            .on("press")
            .to("on")
            .from("on")
            .on("press")
            .to("off")
            .build();

    private final List<String> heard = new ArrayList<>();
    private final PushMonitor panel = new PushMonitor("Panel");

    @Test
    void sendsRefusesAndListens() throws InterruptedException {
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("lamp", new ManualClock()).withoutThreads())) {
            converter.addMonitor(panel);
            converter.addExecute(EventExecute.of("Lamp", Set.of("press"), step -> {
                if (step.source().name().equals("on")) {
                    throw new IllegalStateException("stuck");
                }
                heard.add("sent " + step.trigger());
            }));
            converter.addAnalyze(EventAnalyze.refuseWhen(
                    press -> press.is("press", "hold") && press.values().truth("night", false), "it is night"));
            converter.addKnowledge(new StateKnowledge(new ModelPair(LAMP, LAMP)));
            converter.addListener(
                    ConverterListener.onEnded(entry -> heard.add(entry.outcome() + " " + entry.detail())));
            converter.addListener(ConverterListener.onMoved((before, after) -> heard.add(before + " to " + after)));
            converter.addListener(ConverterListener.onFailed(
                    failure -> heard.add(failure.cause().getMessage())));
            converter.build();
            converter.start();
            for (Values values : List.of(Values.of("night", true), Values.NONE, Values.of("by", "remote"))) {
                panel.press("press", values);
                converter.observe(panel);
                while (converter.step()) {
                    converter.observe(panel);
                }
            }
        }
        assertThat(heard)
                .containsExactly(
                        "IGNORED it is night",
                        "sent press",
                        "(off, off) to (on, off)",
                        "(on, off) to (on, on)",
                        "HANDLED press",
                        "stuck",
                        "FAILED Lamp.execute: stuck");
    }

    @Test
    void aValueThatIsMissingHasAnother() {
        Values values = Values.of("load", 4).with("room", "hall").with("lit", true);
        assertThat(values.number("load", 0)).isEqualTo(4);
        assertThat(values.number("weight", 7)).isEqualTo(7);
        assertThat(values.text("floor", "cellar")).isEqualTo("cellar");
        assertThat(values.truth("lit", false)).isTrue();
        assertThatThrownBy(() -> values.number("room", 0)).isInstanceOf(IllegalArgumentException.class);
    }
}
