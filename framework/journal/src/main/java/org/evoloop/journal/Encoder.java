package org.evoloop.journal;

import org.evoloop.engine.Inputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.engine.codec.ElementWriter;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/** Encodes each input that it receives; {@link Decoder} reads it. */
final class Encoder implements Inputs {
    private final Masks masks;
    private ByteWriter bytes;
    private ElementWriter elements;

    /** @param masks the values that are not written */
    Encoder(Masks masks) {
        this.masks = masks;
        this.bytes = ByteWriter.withTable();
        this.elements = new ElementWriter(bytes);
    }

    /** The record. */
    ByteWriter bytes() {
        return bytes;
    }

    /** Continues a segment in which names were written. */
    void use(ByteWriter names) {
        bytes = names;
        elements = new ElementWriter(names);
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
        begin(Kind.OBSERVED);
        elements.occurrence(masks.of(occurrence));
    }

    @Override
    public void timerDue(long visit, Event event, long atNanos) {
        begin(Kind.TIMER_DUE, atNanos);
        bytes.number(visit);
        elements.event(event);
    }

    @Override
    public void ready() {
        begin(Kind.READY);
    }

    @Override
    public void planned(long number, Decision decision, long atNanos) {
        begin(Kind.PLANNED, number);
        bytes.number(atNanos);
        elements.decision(decision);
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
