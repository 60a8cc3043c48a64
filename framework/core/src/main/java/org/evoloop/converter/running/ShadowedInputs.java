package org.evoloop.converter.running;

import org.evoloop.engine.Input;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Passes inputs on, then tells the shadow of them, if there is one. An input that is refused with an exception has not
 * come.
 *
 * <p>Threading: guarded by the lock of its {@link CoreDriver}.
 */
final class ShadowedInputs implements Inputs {
    private final Inputs next;

    /** Null if there is none. */
    @Nullable
    ShadowCore shadow;

    ShadowedInputs(Inputs next) {
        this.next = next;
    }

    @Override
    public void opened(long atNanos) {
        next.opened(atNanos);
        if (shadow != null) {
            shadow.took(new Input.Opened(atNanos));
        }
    }

    @Override
    public void closing() {
        next.closing();
        if (shadow != null) {
            shadow.took(new Input.Closing());
        }
    }

    @Override
    public void closed() {
        next.closed();
        if (shadow != null) {
            shadow.took(new Input.Closed());
        }
    }

    @Override
    public void recovered(long atNanos) {
        next.recovered(atNanos);
        if (shadow != null) {
            shadow.took(new Input.Recovered(atNanos));
        }
    }

    @Override
    public void observed(Occurrence occurrence) {
        next.observed(occurrence);
        if (shadow != null) {
            shadow.took(new Input.Observed(occurrence));
        }
    }

    @Override
    public void timerDue(long visit, Event event, long atNanos) {
        next.timerDue(visit, event, atNanos);
        if (shadow != null) {
            shadow.took(new Input.TimerDue(visit, event, atNanos));
        }
    }

    @Override
    public void ready() {
        next.ready();
        if (shadow != null) {
            shadow.took(new Input.Ready());
        }
    }

    @Override
    public void planned(long number, Decision decision, long atNanos) {
        next.planned(number, decision, atNanos);
        if (shadow != null) {
            shadow.took(new Input.Planned(number, decision, atNanos));
        }
    }

    @Override
    public void dismissed(long number, long atNanos) {
        next.dismissed(number, atNanos);
        if (shadow != null) {
            shadow.took(new Input.Dismissed(number, atNanos));
        }
    }

    @Override
    public void sending(long number) {
        next.sending(number);
        if (shadow != null) {
            shadow.took(new Input.Sending(number));
        }
    }

    @Override
    public void sent(long number, boolean inOrder, long atNanos) {
        next.sent(number, inOrder, atNanos);
        if (shadow != null) {
            shadow.took(new Input.Sent(number, inOrder, atNanos));
        }
    }

    @Override
    public void running(long number) {
        next.running(number);
        if (shadow != null) {
            shadow.took(new Input.Running(number));
        }
    }

    @Override
    public void effectRun(long number, String failure, long atNanos) {
        next.effectRun(number, failure, atNanos);
        if (shadow != null) {
            shadow.took(new Input.EffectRun(number, failure, atNanos));
        }
    }

    @Override
    public void located(long number, @Nullable State state, long atNanos) {
        next.located(number, state, atNanos);
        if (shadow != null) {
            shadow.took(new Input.Located(number, state, atNanos));
        }
    }

    @Override
    public void failed(long number, String reason, long atNanos) {
        next.failed(number, reason, atNanos);
        if (shadow != null) {
            shadow.took(new Input.Failed(number, reason, atNanos));
        }
    }

    @Override
    public void givenUp(long number, String reason, long atNanos) {
        next.givenUp(number, reason, atNanos);
        if (shadow != null) {
            shadow.took(new Input.GivenUp(number, reason, atNanos));
        }
    }

    @Override
    public void changed(Rules rules, long atNanos) {
        next.changed(rules, atNanos);
        if (shadow != null) {
            shadow.took(new Input.Changed(rules, atNanos));
        }
    }

    @Override
    public void evolved(Swap swap, long atNanos) {
        next.evolved(swap, atNanos);
        if (shadow != null) {
            shadow.took(new Input.Evolved(swap, atNanos));
        }
    }
}
