package org.evoloop.journal;

import java.util.List;
import java.util.Map;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.engine.codec.DecisionKind;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Encodes each input that it receives; {@link Decoder} reads it. */
final class Encoder implements Inputs {
    Bytes bytes = new Bytes();
    private final Masks masks;

    /** @param masks the values that are not written */
    Encoder(Masks masks) {
        this.masks = masks;
    }

    private void begin(Kind kind) {
        bytes.clear();
        bytes.octet(kind.code());
    }

    private void begin(Kind kind, long number) {
        begin(kind);
        bytes.number(number);
    }

    /** @throws IllegalStateException always, since other models are written in the head of a new segment */
    @Override
    public void evolved(Swap swap, long atNanos) {
        throw new IllegalStateException("other models are no record");
    }

    @Override
    public void opened(long atNanos) {
        begin(Kind.OPENED, atNanos);
    }

    @Override
    public void closing() {
        begin(Kind.CLOSING);
    }

    @Override
    public void closed() {
        begin(Kind.CLOSED);
    }

    @Override
    public void recovered(long atNanos) {
        begin(Kind.RECOVERED, atNanos);
    }

    @Override
    public void observed(Occurrence occurrence) {
        begin(Kind.OBSERVED, occurrence.observedNanos());
        if (occurrence instanceof Occurrence.Heard heard) {
            bytes.octet('h');
            bytes.number(heard.visit());
            bytes.name(heard.source().name());
            bytes.truth(heard.deviceActed());
            event(heard.event());
            bytes.names(heard.holding());
            values(masks.of(heard.event().name(), heard.values()));
        } else if (occurrence instanceof Occurrence.Asked asked) {
            bytes.octet('a');
            bytes.number(asked.visit());
            event(asked.event());
            values(masks.of(asked.event().name(), asked.values()));
        } else if (occurrence instanceof Occurrence.Found found) {
            bytes.octet('f');
            bytes.name(found.state().name());
        } else if (occurrence instanceof Occurrence.InDoubt inDoubt) {
            bytes.octet('d');
            bytes.text(inDoubt.why());
        } else if (occurrence instanceof Occurrence.Violated violated) {
            bytes.octet('v');
            bytes.text(violated.property());
        }
    }

    private void event(Event event) {
        bytes.name(event.name());
        bytes.names(event.guards());
    }

    private void values(Map<String, Object> values) {
        bytes.number(values.size());
        if (values.isEmpty()) {
            return;
        }
        values.forEach((name, value) -> {
            bytes.name(name);
            if (value instanceof String text) {
                bytes.octet('s');
                bytes.text(text);
            } else if (value instanceof Double number) {
                bytes.octet('n');
                bytes.fraction(number);
            } else {
                bytes.octet(Boolean.TRUE.equals(value) ? 't' : 'f');
            }
        });
    }

    @Override
    public void timerDue(long visit, Event event, long atNanos) {
        begin(Kind.TIMER_DUE, atNanos);
        bytes.number(visit);
        event(event);
    }

    @Override
    public void ready() {
        begin(Kind.READY);
    }

    @Override
    public void planned(long number, Decision decision, long atNanos) {
        begin(Kind.PLANNED, number);
        bytes.number(atNanos);
        bytes.name(DecisionKind.of(decision).word());
        at(decision.before());
        at(decision.after());
        Transition transition = decision.transition();
        bytes.truth(transition != null);
        if (transition != null) {
            arc(transition);
        }
        List<Step> steps = decision.steps();
        bytes.number(steps.size());
        for (int index = 0; index < steps.size(); index++) {
            Step step = steps.get(index);
            bytes.truth(step.byDevice());
            bytes.truth(step.conditional());
            arc(step.transition());
        }
        bytes.names(decision.effects());
        bytes.text(DecisionKind.reasonOf(decision));
    }

    private void at(Configuration at) {
        bytes.name(at.original().name());
        bytes.name(at.evolved().name());
    }

    private void arc(Transition transition) {
        bytes.name(transition.source().name());
        event(transition.event());
        bytes.name(transition.target().name());
    }

    @Override
    public void dismissed(long number, long atNanos) {
        begin(Kind.DISMISSED, number);
        bytes.number(atNanos);
    }

    @Override
    public void sending(long number) {
        begin(Kind.SENDING, number);
    }

    @Override
    public void sent(long number, boolean inOrder, long atNanos) {
        begin(Kind.SENT, number);
        bytes.number(atNanos);
        bytes.truth(inOrder);
    }

    @Override
    public void running(long number) {
        begin(Kind.RUNNING, number);
    }

    @Override
    public void effectRun(long number, String failure, long atNanos) {
        begin(Kind.EFFECT_RUN, number);
        bytes.number(atNanos);
        bytes.text(failure);
    }

    @Override
    public void located(long number, @Nullable State state, long atNanos) {
        begin(Kind.LOCATED, number);
        bytes.number(atNanos);
        bytes.truth(state != null);
        if (state != null) {
            bytes.name(state.name());
        }
    }

    @Override
    public void failed(long number, String reason, long atNanos) {
        begin(Kind.FAILED, number);
        bytes.number(atNanos);
        bytes.text(reason);
    }

    @Override
    public void givenUp(long number, String reason, long atNanos) {
        begin(Kind.GIVEN_UP, number);
        bytes.number(atNanos);
        bytes.text(reason);
    }

    /** The rules are written in the head of the segment, see {@link Recorder#changed}. */
    @Override
    public void changed(Rules rules, long atNanos) {
        begin(Kind.CHANGED, atNanos);
    }
}
