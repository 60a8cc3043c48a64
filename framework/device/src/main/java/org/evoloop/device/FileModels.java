package org.evoloop.device;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Problems;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.jspecify.annotations.Nullable;

/**
 * The names that a device file may use, those of its models; and which of them it has used. A name that the models do
 * not have is noted with its line.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class FileModels {
    private static final String ONLY_STATE = "Any";

    private final String converter;
    private final @Nullable ModelPair pair;
    private final Problems problems;
    private final Set<String> sent = new LinkedHashSet<>();
    private final Set<String> devicesOwn = new LinkedHashSet<>();
    private final Set<String> reported = new LinkedHashSet<>();
    private final Set<String> pressed = new LinkedHashSet<>();
    private final Set<String> readings = new LinkedHashSet<>();
    private final Set<String> withFunction = new LinkedHashSet<>();
    private final List<Node.Text> sentByFunctions = new ArrayList<>();

    /**
     * The reader of a file makes one; a test of a {@link ConnectionKind} can, too.
     *
     * @param converter the converter's name
     * @param pair null if the file has no models: then every event is known
     * @param problems receives the mistakes
     */
    public FileModels(String converter, @Nullable ModelPair pair, Problems problems) {
        this.converter = converter;
        this.pair = pair;
        this.problems = problems;
    }

    /** Whether it is an event of the original model; without models, any is. */
    public boolean isOfTheDevice(String event) {
        return pair == null || pair.original().triggers().contains(new Event(event));
    }

    /** Whether it is a state of the original model; without models, any is. */
    public boolean isStateOfTheDevice(String state) {
        return pair == null || !pair.original().alike(new State(state)).isEmpty();
    }

    /** The models, once the whole file has been read; without any in the file, those that assume nothing. */
    public ModelPair models() {
        return pair == null ? free() : pair;
    }

    /** The converter's name. */
    public String converter() {
        return converter;
    }

    /** An event that is sent to the device. */
    public String sent(Node.Text event) {
        sent.add(event.value());
        return ofTheDevice(event);
    }

    /** An event that the device raises by itself. */
    public String devicesOwn(Node.Text event) {
        devicesOwn.add(event.value());
        return ofTheDevice(event);
    }

    private String ofTheDevice(Node.Text event) {
        if (pair != null) {
            require(
                    event,
                    "an event of the original model",
                    events(pair.original().triggers()));
        }
        return event.value();
    }

    /** An event of the controller. */
    public String pressed(Node.Text event) {
        pressed.add(event.value());
        if (pair != null) {
            Set<String> known = new LinkedHashSet<>(events(pair.evolved().triggers()));
            known.addAll(events(pair.original().triggers()));
            require(event, "an event of the models", known);
        }
        return event.value();
    }

    /** An event that is raised at times of day. */
    String scheduled(Node.Text event) {
        pressed.add(event.value());
        return raisable(event, "scheduled");
    }

    /** An event that a controller can raise. */
    String raisable(Node.Text event, String to) {
        Set<String> known = new LinkedHashSet<>();
        if (pair != null) {
            known.addAll(events(pair.evolved().triggers()));
            known.addAll(events(pair.original().triggers()));
            known.removeAll(events(pair.original().spontaneous()));
            known.removeAll(devicesOwn);
        }
        known.addAll(sent);
        require(event, "an event that can be " + to, known);
        return event.value();
    }

    /** A state of the device. */
    public String deviceState(Node.Text state) {
        reported.add(state.value());
        if (pair != null && pair.original().alike(new State(state.value())).isEmpty()) {
            require(
                    state,
                    "a state of the original model",
                    names(pair.original().states()));
        }
        return state.value();
    }

    /** Notes a reading that the file declares. */
    void declareReading(Node.Text reading) {
        readings.add(reading.value());
    }

    /** A reading of the device; if the file declares none, a connection may have some of its own. */
    String reading(Node.Text reading) {
        if (!readings.isEmpty()) {
            problems.requireOneOf(reading, readings, "'" + reading + "' is no reading of the device");
        }
        return reading.value();
    }

    /** Any event that the converter can hear of. */
    void known(Node.Text event) {
        Set<String> known = new LinkedHashSet<>(sent);
        known.addAll(devicesOwn);
        known.addAll(pressed);
        if (pair != null) {
            known.addAll(events(pair.evolved().triggers()));
            known.addAll(events(pair.original().triggers()));
        }
        require(event, "an event of this file", known);
    }

    /** A state of the new model. */
    void evolvedState(Node.Text state) {
        if (pair != null && pair.evolved().alike(new State(state.value())).isEmpty()) {
            require(state, "a state of the new model", names(pair.evolved().states()));
        }
    }

    /** A state of the new model that the device does not have. */
    void newState(Node.Text state) {
        if (pair == null) {
            problems.at(state, "without models there are no new states; give models first");
            return;
        }
        withFunction.add(state.value());
        List<State> meant = pair.evolved().alike(new State(state.value()));
        if (meant.isEmpty()) {
            require(state, "a state of the new model", names(pair.evolved().states()));
        } else if (!pair.isNew(meant.get(0))) {
            problems.at(state, "'" + state + "' is a state of the device, which has no function; only new states have");
        }
    }

    /** An event that a function sends. */
    String functionSends(Node.Text event) {
        sentByFunctions.add(event);
        return event.value();
    }

    /** An event that the function of {@code state} raises. */
    String raisedIn(Node.Text state, Node.Text event) {
        if (pair != null) {
            Set<String> known = new LinkedHashSet<>();
            for (State each : pair.evolved().alike(new State(state.value()))) {
                pair.evolved()
                        .transitionsFrom(each)
                        .forEach(next -> known.add(next.event().trigger().name()));
            }
            if (!known.isEmpty()) {
                problems.requireOneOf(event, known, "the new model has no transition for '" + event + "' in " + state);
            }
        }
        return event.value();
    }

    /** The text of a guard. */
    void guard(Node.Text text) {
        if (pair != null) {
            Set<String> drawn = new LinkedHashSet<>(pair.original().guards());
            drawn.addAll(pair.evolved().guards());
            require(text, "a guard of the models", drawn);
        }
    }

    /** The text of an effect. */
    void effect(Node.Text text) {
        if (pair != null) {
            Set<String> drawn = new LinkedHashSet<>();
            pair.evolved().transitions().forEach(transition -> drawn.addAll(transition.effects()));
            require(text, "an effect of the new model", drawn);
        }
    }

    /** Checks what can only be known once the whole file has been read. */
    void checkAll(Section file) {
        Node place = file.any("device").orElse(file.node());
        if (sent.isEmpty() && !problems.isEmpty()) {
            // What was refused may have been all that is sent.
            return;
        }
        for (Node.Text event : sentByFunctions) {
            require(event, "an event that is sent to the device", sent);
        }
        if (pair == null) {
            // An event that is not sent yet may be one of a model that is not drawn yet, unless it looks misspelt.
            pressed.stream()
                    .filter(event ->
                            !sent.contains(event) && !Names.meant(event, sent).isEmpty())
                    .forEach(event -> problems.at(
                            place, "a control raises '" + event + "', which is not sent" + Names.hint(event, sent)));
            return;
        }
        checkThatAllIsSent(pair, place);
        checkFunctions(pair, file.any("functions").orElse(file.node()));
    }

    private void checkThatAllIsSent(ModelPair known, Node place) {
        Set<String> own = new LinkedHashSet<>(devicesOwn);
        own.addAll(events(known.original().spontaneous()));
        for (String event : events(known.original().triggers())) {
            boolean isTimed = new Event(event).timeTrigger().isPresent();
            if (!sent.contains(event) && !own.contains(event) && !isTimed) {
                problems.at(
                        place,
                        "nothing sends '" + event + "', an event of the original model; add it under"
                                + " device.send or, if only the device raises it, under device.does or as spontaneous in the model");
            }
        }
    }

    private void checkFunctions(ModelPair known, Node place) {
        for (State state : known.evolved().states()) {
            if (known.isNew(state)
                    && known.whereDeviceMustBe(state).isEmpty()
                    && known.evolved().timers(state).isEmpty()
                    && !isNamed(state, known, withFunction)) {
                String meant = Names.meant(state.name(), names(known.original().states()));
                problems.at(
                        place,
                        "new state '" + state + "' has no function" + meant + (meant.isEmpty() ? "; " : " Else ")
                                + "add it under functions, with {} if nothing has to run");
            }
        }
    }

    /** Whether one of {@code names} is that of {@code state}, whatever history it remembers. */
    static boolean isNamed(State state, ModelPair known, Collection<String> names) {
        return names.stream()
                .anyMatch(name -> known.evolved().alike(new State(name)).contains(state));
    }

    private void require(Node.Text name, String what, Collection<String> known) {
        problems.requireOneOf(name, known, "'" + Names.inOneLine(name.value()) + "' is not " + what);
    }

    /** Their names; the timers of a model are raised by nobody. */
    private static Set<String> events(Set<Event> events) {
        return events.stream()
                .filter(event -> event.timeTrigger().isEmpty())
                .map(Event::name)
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private static List<String> names(Set<State> states) {
        return states.stream().map(State::name).toList();
    }

    /** The events that controls raise. */
    Set<String> allPressed() {
        return Set.copyOf(pressed);
    }

    /** The events that are sent. */
    Set<String> allSent() {
        return sent;
    }

    /**
     * Models in which nothing is assumed of the device: the states that it reports, or one, each with a loop for every event.
     *
     * @param more further events
     */
    ModelPair free(String... more) {
        Set<String> states = reported.isEmpty() ? Set.of(ONLY_STATE) : reported;
        Set<String> events = new LinkedHashSet<>(sent);
        events.addAll(devicesOwn);
        events.addAll(List.of(more));
        StateMachineBuilder machine =
                StateMachine.named("original").initial(states.iterator().next());
        for (String state : states) {
            events.forEach(event -> machine.transition(state, event, state));
        }
        devicesOwn.forEach(machine::spontaneous);
        StateMachine any = machine.build();
        return new ModelPair(any, any.withName("new"));
    }

    /** The states that the device reports, as the file says. */
    Set<String> allReported() {
        return reported;
    }

    /** The events that the device raises by itself, as the file says. */
    Set<String> allDevicesOwn() {
        return devicesOwn;
    }
}
