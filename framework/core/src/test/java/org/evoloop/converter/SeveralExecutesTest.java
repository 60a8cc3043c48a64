package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A hook of one execute component that throws an error, such as a missing class, does not keep others from theirs. */
class SeveralExecutesTest {
    private static final StateMachine LAMP = machine("lamp", "Off press -> On", "On press -> Off");

    private final List<String> calls = new ArrayList<>();
    private final PushMonitor button = new PushMonitor("Button");
    private final SystemEventConverter converter = new SystemEventConverter(
            LoopConfig.defaults("lamp", new ManualClock()).withoutThreads());
    private boolean broken;
    private boolean unanswered;

    private void fails() {
        if (broken) {
            throw new NoClassDefFoundError("org/bulb/Driver");
        }
    }

    private final class Bulb extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("press");
        }

        @Override
        protected void send(Step step) throws UnknownEffectException {
            if (unanswered) {
                throw new UnknownEffectException("no answer");
            }
        }

        @Override
        protected Optional<String> locate() {
            fails();
            return Optional.empty();
        }

        @Override
        protected void settled(Configuration now) {
            fails();
        }
    }

    private final class Meter extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of();
        }

        @Override
        protected void send(Step step) {}

        @Override
        protected Optional<String> locate() {
            calls.add("locate");
            return Optional.of("On");
        }

        @Override
        protected void settled(Configuration now) {
            calls.add("settled in " + now);
        }
    }

    @BeforeEach
    void start() {
        converter.addMonitor(button);
        converter.addExecute(new Bulb());
        converter.addExecute(new Meter());
        converter.addKnowledge(new StateKnowledge(new ModelPair(LAMP, LAMP)));
        converter.build();
        converter.start();
        calls.clear();
        broken = true;
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private void press() throws InterruptedException {
        button.press("press");
        converter.observe(button);
        while (converter.step()) {
            // One after the other.
        }
    }

    private String lastFailureOfBulb() {
        return converter.status().components().stream()
                .filter(component -> component.name().equals("Bulb"))
                .findFirst()
                .orElseThrow()
                .lastFailure();
    }

    @Test
    void theOthersSettle() throws InterruptedException {
        press();
        assertThat(calls).containsExactly("settled in (On, On)");
        assertThat(lastFailureOfBulb()).isEqualTo("Bulb.settled: org/bulb/Driver");
    }

    @Test
    void theOthersAreAskedWhereTheDeviceIs() throws InterruptedException {
        unanswered = true;
        press();
        assertThat(calls).startsWith("locate");
        assertThat(converter.status().doubt()).isEmpty();
        assertThat(converter.knowledge().configuration()).hasToString("(On, On)");
    }
}
