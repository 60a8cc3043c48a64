package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.awaitility.Awaitility;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.loop.Component;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class OutlookTest {
    private final AtomicBoolean answers = new AtomicBoolean(true);
    private final AtomicInteger made = new AtomicInteger();
    private final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("robot", new ManualClock()));
    private final Panel panel = new Panel();

    private static final class Panel extends PushMonitor {
        Panel() {
            super("Panel");
        }

        void acts(String event) {
            push(fromDevice(event));
        }
    }

    private static final class Robot extends StateKnowledge {
        Robot(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            function("Move", visit -> {});
            timer("SpotWait", "timeout", Duration.ofSeconds(600));
        }
    }

    @BeforeEach
    void start() {
        converter.addMonitor(panel);
        converter.addExecute(new EventExecute("Robot") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("Clean", "Spot");
            }

            @Override
            protected void send(Step step) throws UnknownEffectException {
                if (!answers.get()) {
                    throw new UnknownEffectException("no answer");
                }
            }
        });
        converter.addKnowledge(new Robot(PaperModels.cleaningRobot()));
        converter.addSpare("Robot2", () -> {
            made.incrementAndGet();
            return new RecordingExecute("Robot", "Clean", "Spot");
        });
        converter.addSpare("Broken", () -> {
            throw new IllegalStateException("there is no port");
        });
        converter.addSpare("Panel2", Panel::new);
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private void press(String event) {
        int before = converter.history().size();
        panel.press(event);
        Awaitility.await().until(() -> converter.history().size() > before);
    }

    private Outlook.Next next(String event) {
        return converter.outlook().events().stream()
                .filter(next -> next.trigger().name().equals(event))
                .findFirst()
                .orElseThrow();
    }

    private Set<String> events() {
        return converter.outlook().events().stream()
                .map(next -> next.trigger().name())
                .collect(Collectors.toSet());
    }

    @Test
    void aControllersEventIsThereWithItsDecisionOrWithout() {
        assertThat(events()).containsExactlyInAnyOrder("Clean", "Spot");
        assertThat(next("Spot").decisions()).isEmpty();
        assertThat(next("Clean").decisions())
                .singleElement()
                .isInstanceOf(Decision.ExistingState.class)
                .extracting(decision -> decision.steps().get(0).trigger().name())
                .isEqualTo("Clean");
        press("Clean");
        assertThat(next("Spot").decisions()).singleElement().isInstanceOf(Decision.NewState.class);
        assertThat(next("Spot").source()).isEqualTo(Source.CONTROLLER);
    }

    @Test
    void whatComesByItselfIsNamedAfterWhoRaisesIt() {
        press("Clean");
        press("Spot");
        assertThat(next("arriveSpot").source()).isEqualTo(Source.FUNCTION);
        press("arriveSpot");
        assertThat(next("endSpot").source()).isEqualTo(Source.DEVICE);
        panel.acts("endSpot");
        Awaitility.await().until(() -> converter.outlook().at().evolved().name().equals("On"));
        press("Clean");
        press("Clean");
        assertThat(next("timeout").source()).isEqualTo(Source.TIMER);
        assertThat(next("timeout").delay()).isEqualTo(Optional.of(Duration.ofSeconds(600)));
        assertThat(next("Clean").delay()).isEmpty();
    }

    @Test
    void theStepInDoubtIsKnown() {
        assertThat(converter.outlook().doubtful()).isEmpty();
        answers.set(false);
        press("Clean");
        Step doubtful = converter.outlook().doubtful().orElseThrow();
        assertThat(doubtful.event()).isEqualTo(new Event("Clean"));
        assertThat(doubtful.target().name()).isEqualTo("On");
    }

    @Test
    void aSpareIsOfferedForItsRoleAndMadeOnce() {
        assertThat(converter.spares(Component.Role.EXECUTE)).containsExactly("Robot2");
        assertThat(converter.spares(Component.Role.MONITOR)).containsExactly("Panel2");
        assertThat(converter.spares(Component.Role.PLAN)).isEmpty();
        converter.exchange("Robot", "Robot2");
        assertThat(made).hasValue(1);
        converter.spares(Component.Role.EXECUTE);
        assertThat(made).as("the first one is in use").hasValue(2);
    }
}
