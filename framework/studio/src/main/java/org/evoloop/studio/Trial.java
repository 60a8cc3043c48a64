package org.evoloop.studio;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.testkit.SimulatedDevice;

/**
 * Models that are tried: the converter's own core, without threads, on a device that is played by its model. A run is
 * replayed from its start each time, so nothing is kept.
 */
final class Trial implements AutoCloseable {
    private static final int MOST_INPUTS = 1_000;
    private static final Duration LONGEST = Duration.ofDays(31);

    /** How much may become due while time passes. */
    private static final int MOST_DUE = 20_000;

    private final ModelPair models;
    private final SimulatedDevice device;
    private final ConverterHarness converter;
    private final Map<String, Boolean> guards = new LinkedHashMap<>();
    private final List<JsonObject> steps = new ArrayList<>();
    private Duration passed = Duration.ZERO;
    private int due;

    private Trial(ModelPair models) {
        this.models = models;
        models.requireValid();
        models.original().guards().forEach(guard -> guards.put(guard, false));
        models.evolved().guards().forEach(guard -> guards.put(guard, false));
        device = SimulatedDevice.of(models.original())
                .guards(this::holds)
                .answersLocate()
                .build();
        converter = ConverterHarness.of(new Tried()).with(device).start();
    }

    private boolean holds(String guard) {
        return guards.getOrDefault(guard, false);
    }

    /** What the models themselves do not say is nothing: functions do nothing, and so do effects. */
    private final class Tried extends StateKnowledge {
        Tried() {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            for (State state : models.evolved().states()) {
                if (models.isNew(state)) {
                    function(state.name(), NewFunction.none());
                }
            }
            guards.keySet().stream()
                    .filter(guard -> !guard.equals("else"))
                    .forEach(guard -> guard(guard, () -> holds(guard)));
            models.evolved().transitions().stream()
                    .flatMap(transition -> transition.effects().stream())
                    .distinct()
                    .forEach(effect -> effect(effect, () -> {}));
        }
    }

    /** Replays a run and says where it leads, and what can happen then. */
    static JsonObject run(ModelPair models, JsonRecord request) {
        try (Trial trial = new Trial(models)) {
            trial.play(request.each("run"));
            return trial.answer();
        }
    }

    private void play(List<JsonRecord> run) {
        if (run.size() > MOST_INPUTS) {
            throw new RequestException("a run has at most " + MOST_INPUTS + " inputs; begin another one");
        }
        run.forEach(this::perform);
    }

    private void perform(JsonRecord input) {
        int received = device.received().size();
        List<HistoryEntry> before = converter.history();
        long last = before.isEmpty() ? 0 : before.get(before.size() - 1).number();
        String refused = "";
        try {
            if (input.has("guard")) {
                String guard = input.text("guard");
                if (!guards.containsKey(guard)) {
                    throw new RequestException("no model has a guard '" + guard + "'");
                }
                guards.put(guard, input.truth("value"));
            } else if (input.has("after")) {
                pass(duration(input.text("after")));
            } else if (input.has("press")) {
                converter.press(input.text("press"));
            } else {
                converter.deviceDoes(input.text("device"));
            }
        } catch (IllegalStateException | IllegalArgumentException impossible) {
            refused = String.valueOf(impossible.getMessage());
        } catch (AssertionError endless) {
            throw new RequestException(
                    String.valueOf(endless.getMessage()).lines().findFirst().orElse("it does not come to rest"));
        }
        List<String> words = converter.history().stream()
                .filter(entry -> entry.number() > last)
                .map(Trial::words)
                .toList();
        List<String> all = device.received();
        steps.add(new JsonObject()
                .put("input", input.copy())
                .put("states", states())
                .putTexts("sent", all.subList(received, all.size()))
                .put("words", refused.isEmpty() ? String.join("; ", words) : refused)
                .put("refused", !refused.isEmpty()));
    }

    private static String words(HistoryEntry entry) {
        String outcome = JsonObject.word(entry.outcome()).replace('-', ' ');
        return entry.occurrence().label() + ": " + (entry.detail().isEmpty() ? outcome : entry.detail());
    }

    private static Duration duration(String text) {
        return new Event("after " + text)
                .timeTrigger()
                .orElseThrow(() -> new RequestException("'" + text + "' is no time; write one such as 2 s or 10 min"));
    }

    /** Lets time pass, from one thing that is due to the next. */
    private void pass(Duration time) {
        passed = passed.plus(time);
        if (passed.compareTo(LONGEST) > 0) {
            throw new RequestException("a run lasts at most " + LONGEST.toDays() + " days; let less time pass");
        }
        Duration left = time;
        while (!left.isZero()) {
            Duration most = left;
            Duration next = converter
                    .clock()
                    .untilNext()
                    .filter(until -> until.compareTo(most) < 0)
                    .orElse(left);
            converter.advance(next);
            left = left.minus(next);
            if (++due > MOST_DUE) {
                throw new RequestException("too much happens in that time; let less of it pass");
            }
        }
    }

    private JsonObject states() {
        return new JsonObject()
                .put("original", device.state())
                .put("new", converter.states().evolved().name());
    }

    private JsonObject answer() {
        List<JsonObject> possible = new ArrayList<>();
        List<JsonObject> impossible = new ArrayList<>();
        DecisionTable table = DecisionTable.compile(models, DeviceEvents.assumedOf(models.original()));
        Configuration at = converter.states();
        for (Event event : events()) {
            if (event.timeTrigger().isEmpty() && !table.isDevicesOwn(event)) {
                press(event, table.decide(at, table.resolve(at, event, this::holds), false), possible, impossible);
            }
        }
        for (Event event : models.original().triggers()) {
            if (table.ownStep(at.original(), event, this::holds) != null
                    && event.timeTrigger().isEmpty()) {
                Decision decision = table.decide(at, table.resolve(at, event, this::holds), true);
                possible.add(outlook("device", event.name(), decision));
            }
        }
        converter
                .clock()
                .untilNext()
                .ifPresent(next -> possible.add(new JsonObject()
                        .put("after", next.toMillis() + " ms")
                        .put("target", "")
                        .putTexts("sent", List.of())
                        .put("words", "until something is due")));
        return new JsonObject()
                .put("states", states())
                .put("time", passed.toMillis() + " ms")
                .put("steps", steps)
                .put("possible", possible)
                .put("impossible", impossible)
                .put(
                        "guards",
                        guards.entrySet().stream()
                                .filter(guard -> !guard.getKey().equals("else"))
                                .map(guard -> new JsonObject()
                                        .put("name", guard.getKey())
                                        .put("value", guard.getValue()))
                                .toList());
    }

    private Set<Event> events() {
        Set<Event> events = new LinkedHashSet<>(models.evolved().triggers());
        events.addAll(models.original().triggers());
        return events;
    }

    private static void press(Event event, Decision decision, List<JsonObject> possible, List<JsonObject> impossible) {
        if (decision instanceof Decision.NotAcceptable) {
            impossible.add(new JsonObject()
                    .put("press", event.name())
                    .put("words", "no effect in " + decision.before().evolved()));
        } else if (decision instanceof Decision.Impossible why) {
            impossible.add(new JsonObject().put("press", event.name()).put("words", why.reason()));
        } else {
            possible.add(outlook("press", event.name(), decision));
        }
    }

    private static JsonObject outlook(String kind, String event, Decision decision) {
        List<String> sent = decision.steps().stream()
                .filter(step -> !step.byDevice())
                .map(step -> step.trigger().name())
                .toList();
        return new JsonObject()
                .put(kind, event)
                .put("target", decision.after().evolved().name())
                .putTexts("sent", sent)
                .put("words", sent.isEmpty() ? "nothing sent" : "sends " + String.join(", ", sent));
    }

    /** A run as a scenario of a device file, which expects what has happened. */
    static JsonObject scenario(ModelPair models, JsonRecord request) {
        StringBuilder yaml = new StringBuilder("  " + quoted(request.text("title")) + ":\n");
        try (Trial trial = new Trial(models)) {
            int received = 0;
            for (JsonRecord input : request.each("run")) {
                if (input.has("guard")) {
                    throw new RequestException("a scenario sets no guard; give the readings of which it is made");
                }
                trial.play(List.of(input));
                String kind = List.of("press", "device", "after").stream()
                        .filter(input::has)
                        .findFirst()
                        .orElse("press");
                List<String> all = trial.device.received();
                yaml.append("    - ")
                        .append(kind)
                        .append(": ")
                        .append(quoted(input.text(kind)))
                        .append('\n');
                yaml.append("      sent: [")
                        .append(all.subList(received, all.size()).stream()
                                .map(Trial::quoted)
                                .collect(Collectors.joining(", ")))
                        .append("]\n      state: ")
                        .append(quoted(trial.converter.states().evolved().name()))
                        .append('\n');
                received = all.size();
            }
        }
        return new JsonObject().put("yaml", yaml.toString());
    }

    /** A text in YAML, plain if that is clear. */
    private static String quoted(String text) {
        boolean plain = text.matches("[\\p{L}][\\p{L}\\p{N} _-]*|[0-9]+ (?:ms|s|min|h)")
                && !text.matches("(?i)true|false|yes|no|on|off|null|y|n");
        return plain ? text : "'" + text.replace("'", "''").replaceAll("\\s", " ") + "'";
    }

    @Override
    public void close() {
        converter.close();
    }
}
