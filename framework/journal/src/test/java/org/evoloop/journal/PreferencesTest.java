package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Costs that depend on values and readings choose the way, and what they chose is recorded. */
class PreferencesTest {
    private static final StateMachine SHUTTLE = StateMachine.named("shuttle")
            .initial("Home")
            .transition("Home", "road", "Works")
            .transition("Home", "rail", "Station")
            .transition("Station", "walk", "Works")
            .transition("Works", "back", "Home")
            .build();

    private static final StateMachine DELIVERY = StateMachine.named("delivery")
            .initial("Home")
            .transition("Home", "road", "Works")
            .transition("Home", "rail", "Station")
            .transition("Station", "walk", "Works")
            .transition("Works", "back", "Home")
            .transition("Home", "deliver", "Works")
            .transition("Home", "survey", "Surveying")
            .transition("Surveying", "deliver", "Works")
            .build();

    private static final ModelPair MODELS = new ModelPair(SHUTTLE, DELIVERY);

    private final ManualClock clock = new ManualClock();
    private final PushMonitor desk = new PushMonitor("Desk");
    private final List<String> sent = new ArrayList<>();
    private boolean snow;

    @TempDir
    private Path directory;

    private StateKnowledge knowledge(ModelPair models) {
        return new StateKnowledge(models) {
            @Override
            protected void registerNewFunctions() {
                function("Surveying", NewFunction.none());
                cost("walk", 2);
                cost("road", values -> snow ? 10 : values.number("tons", 0) > 3 ? 5 : 1);
            }
        };
    }

    private SystemEventConverter start() {
        SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("shuttle", clock).withoutThreads());
        converter.addMonitor(desk);
        converter.addExecute(EventExecute.of(
                "Shuttle",
                Set.of("road", "rail", "walk", "back"),
                step -> sent.add(step.trigger().name())));
        converter.addKnowledge(knowledge(MODELS));
        converter.addKnowledgeFactory(this::knowledge);
        converter.journal(Journal.in(directory));
        converter.build();
        converter.start();
        return converter;
    }

    private EventOutcome press(SystemEventConverter converter, String event, Values values) {
        CompletableFuture<EventOutcome> outcome = desk.submit(event, values);
        assertThat(converter.step()).isTrue();
        return outcome.join();
    }

    @Test
    void theyChooseTheWayAndAReplayAndAShadowTakeTheSame() throws Exception {
        try (SystemEventConverter converter = start()) {
            converter.shadow(Evolution.to(knowledge(MODELS)));
            assertThat(press(converter, "deliver", Values.of("tons", 2))).hasToString("handled: Works, sent road");
            press(converter, "back", Values.NONE);
            assertThat(press(converter, "deliver", Values.of("tons", 4)))
                    .hasToString("handled: Works, sent rail, walk");
            press(converter, "back", Values.NONE);
            snow = true;
            assertThat(press(converter, "survey", Values.NONE).isHandled()).isTrue();
            assertThat(press(converter, "deliver", Values.NONE)).hasToString("handled: Works, sent rail, walk");
            press(converter, "back", Values.NONE);
            assertThat(converter.shadow().orElseThrow().report().different()).isZero();
        }
        assertThat(sent).containsExactly("road", "back", "rail", "walk", "back", "rail", "walk", "back");
        DryRun.Result replayed = DryRun.of(new JournalFiles(directory), MODELS, List.of());
        assertThat(replayed.events()).isEqualTo(7);
        assertThat(replayed.differences()).isEmpty();
    }

    @Test
    void aCostOutOfRangeFailsTheEvent() {
        snow = true;
        try (SystemEventConverter converter = start()) {
            assertThat(press(converter, "deliver", Values.of("tons", "many")).isHandled())
                    .as("snow decides first")
                    .isTrue();
            press(converter, "back", Values.NONE);
            snow = false;
            assertThat(press(converter, "deliver", Values.of("tons", "many"))).isInstanceOf(EventOutcome.Failed.class);
            assertThat(sent).containsExactly("rail", "walk", "back");
        }
    }
}
