package org.evoloop.fleet.wire;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.evoloop.engine.Rules;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.fleet.device.Model;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFile;

/**
 * A pair of models in {@link Topic#MODELS}.
 *
 * @param file the model file's name in messages
 * @param text the model file
 * @param original the name of the device's state machine in it
 * @param evolved the name of the wanted state machine in it
 * @param timers the timers of states, in addition to those in the diagrams
 * @param uses what new states need of the device, in addition to what is drawn: what a program declares in code
 * @param queueCapacity how many events of controllers may wait
 * @since 0.1
 */
public record ModelRecord(
        String file,
        String text,
        String original,
        String evolved,
        List<Timer> timers,
        List<Use> uses,
        int queueCapacity) {
    /** The schema of a record with uses: who does not know them would decide otherwise, and must refuse it. */
    private static final int USES = 2;

    /** The default queue capacity. */
    public static final int QUEUE = 8;

    private static final Pattern VERSION = Pattern.compile("[A-Za-z0-9._-]{1,100}");
    private static final int MOST_WAITING = 1_000;

    /** A longer timer would be due at a time that cannot be expressed in nanoseconds since 1970. */
    private static final Duration LONGEST = Duration.ofDays(100 * 365);

    /** An event raised {@code millis} after {@code state} is entered. */
    public record Timer(String state, String event, long millis) {}

    /**
     * What a new state needs of the device.
     *
     * @param device where it must be; empty if that is not said
     * @param sends what the state's function may send to it
     */
    public record Use(String state, String device, List<String> sends) {}

    /** One without uses. */
    public ModelRecord(
            String file, String text, String original, String evolved, List<Timer> timers, int queueCapacity) {
        this(file, text, original, evolved, timers, List.of(), queueCapacity);
    }

    /** Parses the result of {@link #bytes}. */
    static ModelRecord of(JsonRecord record) {
        List<Timer> timers = record.each("timers").stream()
                .map(timer -> new Timer(timer.text("state"), timer.text("event"), timer.number("millis")))
                .toList();
        return new ModelRecord(
                record.text("file"),
                record.text("text"),
                record.text("original"),
                record.text("new"),
                timers,
                record.each("uses").stream().map(ModelRecord::use).toList(),
                (int) Math.max(0, Math.min(MOST_WAITING, record.number("queue", QUEUE))));
    }

    private static Use use(JsonRecord use) {
        return new Use(use.text("state"), use.text("device", ""), use.texts("sends"));
    }

    /** The record. */
    public byte[] bytes() {
        JsonObject json = Wire.record(uses.isEmpty() ? Wire.SCHEMA : USES)
                .put("file", file)
                .put("original", original)
                .put("new", evolved)
                .put("queue", queueCapacity)
                .put(
                        "timers",
                        timers.stream()
                                .map(timer -> new JsonObject()
                                        .put("state", timer.state)
                                        .put("event", timer.event)
                                        .put("millis", timer.millis))
                                .toList());
        if (!uses.isEmpty()) {
            json.put(
                    "uses",
                    uses.stream()
                            .map(use -> new JsonObject()
                                    .put("state", use.state)
                                    .putSome("device", use.device)
                                    .putTexts("sends", use.sends))
                            .toList());
        }
        return json.put("text", text).toBytes();
    }

    /**
     * The models of a record, compiled.
     *
     * @throws Refusal naming the problem
     */
    public static Model read(String version, byte[] bytes) {
        if (!VERSION.matcher(version).matches()) {
            throw new Refusal(
                    Refusal.Reason.UNUSABLE_MODEL,
                    "'" + version + "' is not a version of models; use letters, digits, '.', '_' and '-', 100 at most");
        }
        ModelRecord record = of(Reading.of(bytes, USES).record());
        try {
            return new Model(version, record.rules());
        } catch (ModelException e) {
            throw new Refusal(Refusal.Reason.UNUSABLE_MODEL, "models " + version + ": " + e.getMessage());
        }
    }

    private Rules rules() {
        ModelFile models = ModelFile.read(file, new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
        ModelPair pair = using(new ModelPair(models.pick(original), models.pick(evolved)));
        pair.requireValid();
        DecisionTable table = DecisionTable.compile(pair, device(pair.original()));
        if (!table.problems().isEmpty()) {
            throw new ModelException(table.problems().get(0).toString());
        }
        timers.forEach(timer -> requireKnown(pair.evolved(), timer));
        Map<State, Map<Event, Duration>> byState = new HashMap<>();
        for (State state : pair.evolved().states()) {
            Map<Event, Duration> own = timers(pair.evolved(), state);
            own.forEach((event, time) -> requireInRange(state, event, time));
            byState.put(state, own);
        }
        return new Rules(table, state -> byState.getOrDefault(state, Map.of()), queueCapacity);
    }

    private ModelPair using(ModelPair drawn) {
        StateMachine evolved = drawn.evolved();
        for (Use use : uses) {
            List<State> states = states(evolved, use.state);
            if (states.isEmpty()) {
                throw new ModelException("there is no state " + use.state + " that could need the device"
                        + Names.hint(use.state, evolved.states()));
            }
            for (State state : states) {
                evolved = using(evolved, state, use, drawn.original());
            }
        }
        return uses.isEmpty() ? drawn : new ModelPair(drawn.original(), evolved);
    }

    private static StateMachine using(StateMachine machine, State state, Use use, StateMachine device) {
        String known = machine.deviceState(state);
        if (known != null && !use.device.isEmpty() && !known.equals(use.device)) {
            throw new ModelException(
                    "state " + state + " has two device states, " + known + " and " + use.device + "; keep one");
        }
        StateMachine changed = use.device.isEmpty() ? machine : machine.withDeviceState(state, use.device);
        for (String name : use.sends) {
            Event event = new Event(name);
            if (!device.triggers().contains(event)) {
                throw new ModelException("the function of " + state + " is to send " + name
                        + ", an event that the device does not know" + Names.hint(name, device.triggers()));
            }
            changed = changed.withSends(state, event);
        }
        return changed;
    }

    private static List<State> states(StateMachine machine, String name) {
        return machine.states().stream()
                .filter(state -> machine.withoutMemory(state).name().equals(name))
                .toList();
    }

    /** A mistyped timer would never fire, and nobody would notice. */
    private static void requireKnown(StateMachine machine, Timer timer) {
        if (states(machine, timer.state).isEmpty()) {
            throw new ModelException("there is no state " + timer.state + " for the timer " + timer.event);
        } else if (!machine.triggers().contains(new Event(timer.event))) {
            throw new ModelException("the timer of the state " + timer.state + " raises " + timer.event
                    + ", an event that " + machine.name() + " does not know");
        }
    }

    private static void requireInRange(State state, Event event, Duration time) {
        if (time.isNegative() || time.compareTo(LONGEST) > 0) {
            throw new ModelException("the timer " + event + " of the state " + state.name() + " is " + time
                    + "; allowed is 0 to 100 years");
        }
    }

    /** All events can be sent to the device, except those declared as its own. */
    private static DeviceEvents device(StateMachine device) {
        Set<Event> sendable = new HashSet<>(device.triggers());
        sendable.removeAll(device.spontaneous());
        sendable.removeIf(event -> event.timeTrigger().isPresent());
        return new DeviceEvents(sendable, Set.of()).declaredBy(device).withBoundGuards(device.guards());
    }

    private Map<Event, Duration> timers(StateMachine machine, State state) {
        Map<Event, Duration> all = new LinkedHashMap<>();
        for (Timer timer : timers) {
            if (machine.withoutMemory(state).name().equals(timer.state)) {
                all.put(new Event(timer.event), Duration.ofMillis(timer.millis));
            }
        }
        all.putAll(machine.timers(state));
        return all;
    }
}
