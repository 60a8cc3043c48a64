package org.evoloop.device;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.testkit.SimulatedDevice;
import org.jspecify.annotations.Nullable;

/**
 * A scenario of a device file: what happens, and what is expected to follow. It runs without threads and waiting, on a
 * device that behaves like the original model.
 *
 * <p>Threading: immutable.
 *
 * @param name in the file
 * @param steps in their order
 * @since 0.1
 */
public record Scenario(String name, List<Line> steps) {
    public Scenario {
        steps = List.copyOf(steps);
    }

    /**
     * A step.
     *
     * @param line in the file, from 1
     * @param text for messages
     * @param action what happens or is expected
     */
    public record Line(int line, String text, Action action) {}

    /** What happens in a step, or is expected. */
    @FunctionalInterface
    public interface Action {
        /**
         * Does it.
         *
         * @throws AssertionError if an expectation fails; the message says what is the case instead
         */
        void perform(Running running);
    }

    /** A scenario that runs. */
    public static final class Running {
        private final ConverterHarness converter;
        private final SimulatedDevice device;
        private int seen;

        Running(ConverterHarness converter, SimulatedDevice device) {
            this.converter = converter;
            this.device = device;
        }

        private List<String> sent() {
            List<String> all = device.received();
            List<String> sent = all.subList(seen, all.size());
            seen = all.size();
            return sent;
        }

        private String evolved() {
            return converter.status().states().evolved().name();
        }
    }

    /** Reads the scenarios of a section. */
    static List<Scenario> read(Section all, FileModels models) {
        List<Scenario> scenarios = new ArrayList<>();
        for (Node.Text name : all.keys()) {
            List<Line> steps = new ArrayList<>();
            for (Section step : all.listed(name.value())) {
                Action action = action(step, models);
                step.done();
                if (action != null) {
                    steps.add(new Line(step.node().line(), step.toString(), action));
                }
            }
            scenarios.add(new Scenario(name.value(), steps));
        }
        return scenarios;
    }

    private static @Nullable Action action(Section step, FileModels models) {
        List<Action> actions = new ArrayList<>();
        step.text("press").ifPresent(event -> {
            models.known(event);
            actions.add(running -> running.converter.press(event.value()));
        });
        step.text("device").ifPresent(event -> {
            models.known(event);
            actions.add(running -> running.converter.deviceDoes(event.value()));
        });
        step.duration("after").ifPresent(time -> actions.add(running -> running.converter.advance(time)));
        List<Node.Text> sent = step.texts("sent");
        if (step.has("sent")) {
            sent.forEach(models::known);
            List<String> expected = sent.stream().map(Node.Text::value).toList();
            actions.add(running -> require("sent", expected, running.sent()));
        }
        step.text("state").ifPresent(state -> {
            models.evolvedState(state);
            actions.add(running -> require("state", state.value(), running.evolved()));
        });
        step.text("device-state").ifPresent(state -> {
            models.deviceState(state);
            actions.add(running -> require("device-state", state.value(), running.device.state()));
        });
        if (actions.isEmpty()) {
            step.problem(step.name() + " needs one of press, device, after, sent, state, device-state");
            return null;
        }
        return running -> actions.forEach(each -> each.perform(running));
    }

    private static void require(String what, Object expected, Object found) {
        if (!expected.equals(found)) {
            throw new AssertionError(what + " is " + found + ", expected is " + expected);
        }
    }

    /**
     * Runs it.
     *
     * @return the line in which it fails, and why: {@code 12: sent is [], expected is [power]}; empty if it passes
     */
    public String run(DeviceFile file) {
        SimulatedDevice device = file.simulated();
        try (ConverterHarness converter =
                ConverterHarness.of(file.knowledge(file.models())).with(device).start()) {
            Running running = new Running(converter, device);
            for (Line step : steps) {
                try {
                    step.action().perform(running);
                } catch (AssertionError | IllegalStateException | IllegalArgumentException failed) {
                    return step.line() + ": " + failed.getMessage();
                }
            }
            return "";
        }
    }
}
