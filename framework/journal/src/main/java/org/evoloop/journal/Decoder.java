package org.evoloop.journal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.evoloop.engine.Input;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.DecisionKind;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Reads the inputs of one segment, in order. */
final class Decoder {
    private final Cursor cursor;
    private final Rules rules;

    /** @param rules the rules by which the segment was written */
    Decoder(Cursor cursor, Rules rules) {
        this.cursor = cursor;
        this.rules = rules;
    }

    /**
     * The input of one record.
     *
     * @throws Cursor.Senseless if it is not an input
     */
    Input read(int from, int length) {
        cursor.goTo(from, length);
        Input input = read(Kind.of(cursor.octet()));
        cursor.requireEnd();
        return input;
    }

    private Input read(Kind kind) {
        return switch (kind) {
            case OPENED -> new Input.Opened(cursor.number());
            case CLOSING -> new Input.Closing();
            case CLOSED -> new Input.Closed();
            case RECOVERED -> new Input.Recovered(cursor.number());
            case OBSERVED -> new Input.Observed(occurrence(cursor.number()));
            case TIMER_DUE -> timerDue(cursor.number());
            case READY -> new Input.Ready();
            case SENDING -> new Input.Sending(cursor.number());
            case RUNNING -> new Input.Running(cursor.number());
            case CHANGED -> new Input.Changed(rules, cursor.number());
            default -> ofOccurrence(kind, cursor.number(), cursor.number());
        };
    }

    private Input ofOccurrence(Kind kind, long number, long atNanos) {
        return switch (kind) {
            case PLANNED -> new Input.Planned(number, decision(), atNanos);
            case DISMISSED -> new Input.Dismissed(number, atNanos);
            case SENT -> new Input.Sent(number, cursor.truth(), atNanos);
            case EFFECT_RUN -> new Input.EffectRun(number, cursor.text(), atNanos);
            case LOCATED -> new Input.Located(number, cursor.truth() ? state() : null, atNanos);
            case FAILED -> new Input.Failed(number, cursor.text(), atNanos);
            case GIVEN_UP -> new Input.GivenUp(number, cursor.text(), atNanos);
            default -> throw new Cursor.Senseless(kind + " is about no occurrence");
        };
    }

    private Input timerDue(long atNanos) {
        long visit = cursor.number();
        return new Input.TimerDue(visit, event(), atNanos);
    }

    private Occurrence occurrence(long observedNanos) {
        int kind = cursor.octet();
        return switch (kind) {
            case 'h' -> heard(observedNanos);
            case 'a' -> asked(observedNanos);
            case 'f' -> new Occurrence.Found(state(), observedNanos);
            case 'v' -> new Occurrence.Violated(cursor.text(), observedNanos);
            case 'd' -> new Occurrence.InDoubt(cursor.text(), observedNanos);
            default -> throw new Cursor.Senseless("there is no occurrence of kind " + kind);
        };
    }

    private Occurrence heard(long observedNanos) {
        long visit = cursor.number();
        Source source = source(cursor.name());
        boolean acted = cursor.truth();
        Event event = event();
        List<String> holding = cursor.names();
        Set<String> sorted = holding.isEmpty() ? Set.of() : new TreeSet<>(holding);
        return new Occurrence.Heard(event, values(), source, acted, sorted, visit, observedNanos);
    }

    private Occurrence asked(long observedNanos) {
        long visit = cursor.number();
        Event event = event();
        return new Occurrence.Asked(event, values(), visit, observedNanos);
    }

    private static Source source(String name) {
        for (Source source : Source.values()) {
            if (source.name().equals(name)) {
                return source;
            }
        }
        throw new Cursor.Senseless("'" + name + "' is not a source of events");
    }

    private Values values() {
        int count = cursor.count();
        if (count == 0) {
            return Values.NONE;
        }
        Map<String, Object> byName = new TreeMap<>();
        for (int read = 0; read < count; read++) {
            byName.put(cursor.name(), value());
        }
        return new Values(byName);
    }

    private Object value() {
        int type = cursor.octet();
        return switch (type) {
            case 's' -> cursor.text();
            case 'n' -> cursor.fraction();
            case 't' -> true;
            case 'f' -> false;
            default -> throw new Cursor.Senseless("there is no value of type " + type);
        };
    }

    private Event event() {
        String name = cursor.name();
        return new Event(name, cursor.names());
    }

    private State state() {
        return new State(cursor.name());
    }

    private Configuration at() {
        State original = state();
        return new Configuration(original, state());
    }

    private Decision decision() {
        String word = cursor.name();
        Configuration before = at();
        Configuration after = at();
        Transition transition = cursor.truth() ? evolved() : null;
        int count = cursor.count();
        List<Step> steps = new ArrayList<>(count);
        while (steps.size() < count) {
            boolean byDevice = cursor.truth();
            boolean conditional = cursor.truth();
            Transition taken = original();
            steps.add(new Step(taken, taken.event().trigger(), byDevice, conditional));
        }
        List<String> effects = cursor.names();
        return made(word, before, after, List.copyOf(steps), transition, effects, cursor.text());
    }

    private static Decision made(
            String word,
            Configuration before,
            Configuration after,
            List<Step> steps,
            @Nullable Transition transition,
            List<String> effects,
            String reason) {
        for (DecisionKind kind : DecisionKind.values()) {
            if (kind.word().equals(word) && (transition != null || !kind.needsTransition())) {
                return kind.made(before, after, steps, transition, effects, reason);
            }
        }
        throw new Cursor.Senseless("'" + word + "' is not a decision that could be made here");
    }

    private Transition original() {
        return transitionOf(rules.table().models().original());
    }

    private Transition evolved() {
        return transitionOf(rules.table().models().evolved());
    }

    private Transition transitionOf(StateMachine model) {
        State source = state();
        Event event = event();
        State target = state();
        Transition found = model.transition(source, event).orElse(null);
        if (found == null || !found.target().equals(target)) {
            throw new Cursor.Senseless(
                    "the model '" + model.name() + "' has no transition " + source + " --" + event + "--> " + target);
        }
        return found;
    }
}
