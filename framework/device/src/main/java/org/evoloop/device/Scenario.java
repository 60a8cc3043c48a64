package org.evoloop.device;

import java.time.Duration;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.converter.DeviceLink;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.function.Reading;
import org.evoloop.mqtt.home.HomeEntity;
import org.evoloop.mqtt.home.HomeTable;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.testkit.SimulatedDevice;
import org.evoloop.time.ManualClock;
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
        private final DeviceFile file;
        private final ConverterHarness converter;
        private final SimulatedDevice device;
        private final ManualClock clock;
        private final Told told;
        private int seen;

        Running(DeviceFile file, ConverterHarness converter, SimulatedDevice device, ManualClock clock, Told told) {
            this.file = file;
            this.converter = converter;
            this.device = device;
            this.clock = clock;
            this.told = told;
        }

        private void awaitTime(LocalTime time) {
            ZonedDateTime now = clock.wallTime().atZone(ZoneId.systemDefault());
            ZonedDateTime next = now.with(time);
            converter.advance(Duration.between(now, next.isAfter(now) ? next : next.plusDays(1)));
        }

        /** Home Assistant gives a command; one that is refused presses nothing. */
        private void command(HomeEntity entity, String command) {
            List<String> events = converter.converter().controllerEvents().stream()
                    .map(Event::name)
                    .toList();
            HomeTable.of(entity, file.models(), events)
                    .presses(converter.status().states().evolved(), command)
                    .forEach(converter::press);
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

    /** The readings that a scenario gives. */
    private static final class Told implements DeviceLink {
        private final Map<String, Reading> readings = new LinkedHashMap<>();

        @Override
        public boolean isUp() {
            return true;
        }

        @Override
        public List<Reading> readings() {
            return List.copyOf(readings.values());
        }

        @Override
        public String describe() {
            return "the readings of a scenario";
        }
    }

    /** Reads the scenarios of a section. */
    static List<Scenario> read(Section all, FileModels models, HomeSection home) {
        List<Scenario> scenarios = new ArrayList<>();
        for (Node.Text name : all.keys()) {
            List<Line> steps = new ArrayList<>();
            for (Section step : all.listed(name.value())) {
                Action action = action(step, models, home);
                step.done();
                if (action != null) {
                    steps.add(new Line(step.node().line(), step.toString(), action));
                }
            }
            scenarios.add(new Scenario(name.value(), steps));
        }
        return scenarios;
    }

    private static @Nullable Action action(Section step, FileModels models, HomeSection home) {
        List<Action> actions = new ArrayList<>();
        if (step.has("readings")) {
            step.pairs("readings").forEach((name, text) -> {
                try {
                    Reading reading = Reading.of(name.value(), Guards.number(text.value()), "");
                    actions.add(running -> running.told.readings.put(reading.name(), reading));
                } catch (IllegalArgumentException wrong) {
                    step.problems().at(text, String.valueOf(wrong.getMessage()));
                }
            });
        }
        step.value("until", Section::timeOfDay).ifPresent(time -> actions.add(running -> running.awaitTime(time)));
        step.text("press").ifPresent(event -> {
            models.known(event);
            actions.add(running -> running.converter.press(event.value()));
        });
        step.pairs("command").forEach((name, command) -> {
            HomeEntity entity = home.named(name.value());
            if (entity == null) {
                step.problems()
                        .at(name, "home-assistant has no '" + name + "'" + Names.hint(name.value(), home.names()));
            } else {
                step.problems()
                        .requireOneOf(command, entity.commandNames(), name + " has no command '" + command + "'");
                actions.add(running -> running.command(entity, command.value()));
            }
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
            step.problem(step.name()
                    + " needs one of readings, until, press, command, device, after, sent, state, device-state");
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
        ManualClock clock = new ManualClock();
        Told told = new Told();
        file.guards().attach(clock, List.of(told));
        ConverterHarness.Builder parts = ConverterHarness.of(file.knowledge(file.models()))
                .with(device)
                .with(file.controller("Controls"))
                .with(file.day().analyze(clock))
                .clock(clock);
        file.day().plan().timetable().ifPresent(parts::with);
        try (ConverterHarness converter = parts.start()) {
            Running running = new Running(file, converter, device, clock, told);
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
