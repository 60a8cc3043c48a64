package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.EventKeywords;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ModelWriter;

/**
 * A machine that was learned, and what is known about it.
 *
 * <p>Threading: immutable.
 *
 * @param machine the machine
 * @param seen how often each of its transitions was taken
 * @param delays when the device takes each of its spontaneous transitions
 * @param untried what was never pressed, and why
 * @param open what keeps the machine from having passed its test; empty if it passed
 * @param cost what it took, without what was known from an earlier learning
 * @since 0.1
 */
public record LearnedModel(
        StateMachine machine,
        Map<Transition, Integer> seen,
        Map<Transition, Delay> delays,
        List<String> untried,
        List<String> open,
        Cost cost) {
    private static final String INITIAL = "initial";

    public LearnedModel {
        seen = Map.copyOf(seen);
        delays = Map.copyOf(delays);
        untried = List.copyOf(untried);
        open = List.copyOf(open);
    }

    /**
     * Between which times a device leaves a state by itself, from the state's first sign on.
     *
     * @param least the shortest time that agrees with what was seen
     * @param most the longest
     */
    public record Delay(Duration least, Duration most) {
        /** For people: {@code 44.9 s to 45.2 s}. */
        @Override
        public String toString() {
            return seconds(least) + " to " + seconds(most);
        }

        private static String seconds(Duration time) {
            return time.toMillis() / 1000.0 + " s";
        }
    }

    /**
     * What was done to a device.
     *
     * @param resets how often it was reset
     * @param presses how often it was pressed
     * @param time how long that took
     */
    public record Cost(int resets, int presses, Duration time) {
        /** For people. */
        @Override
        public String toString() {
            return resets + " resets and " + presses + " presses in " + time.toSeconds() + " s";
        }
    }

    /** Whether the machine passed its test. */
    public boolean passed() {
        return open.isEmpty();
    }

    /** What is known about the machine, a line each. */
    public List<String> notes() {
        List<String> notes = new ArrayList<>();
        notes.add("Learned from the device: " + cost + ".");
        notes.add(
                passed()
                        ? "It passed its test to depth 1; that there are no more states is not proved."
                        : "It did not pass its test.");
        open.forEach(what -> notes.add("Open: " + what));
        for (Transition transition : machine.transitions()) {
            Delay delay = delays.get(transition);
            notes.add(transition.source() + ", " + transition.event() + ", " + transition.target() + ": seen "
                    + seen.getOrDefault(transition, 0) + " times" + (delay == null ? "" : ", after " + delay));
        }
        untried.forEach(what -> notes.add("Untried: " + what));
        return notes;
    }

    /**
     * The machine as the text of a model file, with the notes as comments at its end.
     *
     * @throws org.evoloop.statemachine.ModelException if the language has no words for a name in it
     */
    public String write(ModelWriter language) {
        String text = language.write(chart());
        String comments = notes().stream()
                .map(note -> language == ModelWriter.MERMAID
                        ? "%% " + note.replaceAll("\\R", " ")
                        : "<!-- " + note.replace("-", "\u2010") + " -->")
                .collect(Collectors.joining("\n"));
        return text + (text.endsWith("\n") ? "" : "\n") + comments + "\n";
    }

    private Statechart chart() {
        List<Vertex> vertices = new ArrayList<>();
        List<Arc> arcs = new ArrayList<>();
        vertices.add(new Vertex.Pseudostate(INITIAL, "", Place.NONE, Vertex.Kind.INITIAL));
        arcs.add(new Arc(Place.NONE, INITIAL, key(machine.initial()), List.of(), "", List.of(), Arc.Kind.EXTERNAL));
        machine.states().forEach(state -> vertices.add(Vertex.ChartState.simple(key(state), state.name(), Place.NONE)));
        machine.transitions()
                .forEach(transition -> arcs.add(new Arc(
                        Place.NONE,
                        key(transition.source()),
                        key(transition.target()),
                        List.of(EventKeywords.drawn(machine, transition.event())),
                        "",
                        List.of(),
                        Arc.Kind.EXTERNAL)));
        Region region = new Region("", Place.NONE, vertices, arcs);
        return new Statechart(
                machine.name(),
                Place.NONE,
                List.of(region),
                machine.events().stream().map(Event::name).toList());
    }

    private static String key(State state) {
        return "state " + state.name();
    }
}
