package org.evoloop.models.record;

import java.util.stream.Collectors;
import org.evoloop.engine.Input;
import org.evoloop.engine.codec.DecisionKind;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;

/** The converter's inputs as text. */
final class InputText {
    private InputText() {}

    static String of(Input input) {
        if (input instanceof Input.Observed observed) {
            return of(observed.occurrence());
        } else if (input instanceof Input.TimerDue due) {
            return due.event() + ", visit " + due.visit();
        } else if (input instanceof Input.Planned planned) {
            return "#" + planned.number() + " " + of(planned.decision());
        } else if (input instanceof Input.Dismissed dismissed) {
            return "#" + dismissed.number();
        } else if (input instanceof Input.Sending sending) {
            return "#" + sending.number();
        } else if (input instanceof Input.Sent sent) {
            return "#" + sent.number();
        } else if (input instanceof Input.Running running) {
            return "#" + running.number();
        } else if (input instanceof Input.EffectRun run) {
            return "#" + run.number() + (run.failure().isEmpty() ? "" : " failed: " + run.failure());
        } else if (input instanceof Input.Located located) {
            State state = located.state();
            return "#" + located.number() + " " + (state == null ? "cannot be told" : state);
        } else if (input instanceof Input.Failed failed) {
            return "#" + failed.number() + " " + failed.reason();
        }
        return input instanceof Input.GivenUp givenUp ? "#" + givenUp.number() + " " + givenUp.reason() : "";
    }

    private static String of(Occurrence occurrence) {
        return occurrence instanceof Occurrence.Asked && !occurrence.values().isEmpty()
                ? occurrence.label() + " (" + occurrence.values() + ")"
                : occurrence.toString();
    }

    private static String of(Decision decision) {
        String steps = decision.steps().stream()
                .map(Step::trigger)
                .map(Object::toString)
                .collect(Collectors.joining(", "));
        String reason = DecisionKind.reasonOf(decision);
        return DecisionKind.of(decision).word()
                + " " + decision.before() + " -> " + decision.after()
                + (steps.isEmpty() ? "" : ", steps " + steps)
                + (reason.isEmpty() ? "" : ": " + reason);
    }
}
