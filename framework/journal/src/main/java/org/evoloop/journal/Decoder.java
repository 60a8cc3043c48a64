package org.evoloop.journal;

import org.evoloop.engine.Input;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.ByteItems;
import org.evoloop.engine.codec.ElementReader;
import org.evoloop.evolution.Decision;

/** Reads the inputs of one segment, in order. */
final class Decoder {
    private final ByteItems cursor;
    private final Rules rules;
    private final ElementReader elements;

    /** @param rules the rules by which the segment was written */
    Decoder(ByteItems cursor, Rules rules) {
        this.cursor = cursor;
        this.rules = rules;
        this.elements = new ElementReader(rules.table().models(), cursor);
    }

    /**
     * The input of one record.
     *
     * @throws RuntimeException if it is not an input
     */
    Input read(int from, int length) {
        cursor.goTo(from, length);
        Input input = read(Kind.of(cursor.octet()));
        cursor.endsAll();
        return input;
    }

    private Input read(Kind kind) {
        return switch (kind) {
            case OPENED -> new Input.Opened(cursor.number());
            case CLOSING -> new Input.Closing();
            case CLOSED -> new Input.Closed();
            case RECOVERED -> new Input.Recovered(cursor.number());
            case OBSERVED -> new Input.Observed(elements.occurrence());
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
            case PLANNED -> planned(number, atNanos);
            case DISMISSED -> new Input.Dismissed(number, atNanos);
            case SENT -> new Input.Sent(number, cursor.truth(), atNanos);
            case EFFECT_RUN -> new Input.EffectRun(number, cursor.text(), atNanos);
            case LOCATED -> new Input.Located(number, cursor.truth() ? elements.state() : null, atNanos);
            case FAILED -> new Input.Failed(number, cursor.text(), atNanos);
            case GIVEN_UP -> new Input.GivenUp(number, cursor.text(), atNanos);
            default -> throw new IllegalArgumentException(kind + " is about no occurrence");
        };
    }

    private Input planned(long number, long atNanos) {
        Decision decision = elements.decision();
        if (decision == null) {
            throw new IllegalArgumentException("a decision is missing");
        }
        return new Input.Planned(number, decision, atNanos);
    }

    private Input timerDue(long atNanos) {
        long visit = cursor.number();
        return new Input.TimerDue(visit, elements.event(), atNanos);
    }
}
