package org.evoloop.check;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** The rules about the code for the new model: functions, events, guards. */
final class ConverterRules {
    private final CheckInput input;
    private final StateMachine evolved;
    private final Set<State> reachable;
    private final List<Finding> findings = new ArrayList<>();

    ConverterRules(CheckInput input, MachineRules evolvedRules) {
        this.input = input;
        this.evolved = input.pair().evolved();
        this.reachable = evolvedRules.reachable();
    }

    List<Finding> findings() {
        input.device().unsendable(input.pair().original()).forEach(this::unsendable);
        Set<String> functions = input.functions();
        if (functions != null) {
            reachable.forEach(state -> function(state, functions));
        }
        Set<String> raised = input.raised();
        if (raised != null) {
            unraised(raised);
        }
        Set<String> guards = input.guards();
        if (guards != null) {
            unbound(guards);
        }
        return findings;
    }

    private void unsendable(Event trigger) {
        findings.add(new Finding(
                Rule.UNSENDABLE_EVENT,
                new Element.OfEvent(Element.ModelRole.ORIGINAL, trigger),
                "event " + trigger
                        + " of the original model can neither be sent nor is it declared to be the device's own",
                "let the converter send it, or declare it: spontaneousEvents of a monitor, option --spontaneous, or the"
                        + " keyword «spontaneous» in the model"));
    }

    private void function(State state, Set<String> functions) {
        boolean timed = !evolved.timers(state).isEmpty();
        boolean known = functions.contains(state.name())
                || functions.contains(evolved.withoutMemory(state).name());
        if (input.pair().isNew(state) && !timed && !known) {
            findings.add(new Finding(
                    Rule.NO_FUNCTION,
                    new Element.OfState(Element.ModelRole.NEW, state),
                    "new state " + state + " has no function",
                    "register one in registerNewFunctions, NewFunction.none() if nothing has to run"));
        }
    }

    private void unraised(Set<String> raised) {
        Set<Event> waitedFor = new LinkedHashSet<>();
        for (State state : reachable) {
            evolved.transitionsFrom(state)
                    .forEach(transition -> waitedFor.add(transition.event().trigger()));
        }
        for (Event trigger : waitedFor) {
            // An event that was meant to be a time trigger is reported as that.
            if (trigger.timeTrigger().isEmpty()
                    && !MachineRules.looksLikeATimer(trigger)
                    && !raised.contains(trigger.name())) {
                findings.add(new Finding(
                        Rule.UNRAISED_EVENT,
                        new Element.OfEvent(Element.ModelRole.NEW, trigger),
                        "nobody raises event " + trigger,
                        "let a monitor, a timer or a function raise it, or use the name under which it is raised"));
            }
        }
    }

    private void unbound(Set<String> guards) {
        for (String text : evolved.guards()) {
            if (!guards.contains(text)) {
                Transition guarded = evolved.transitions().stream()
                        .filter(transition -> transition.event().guards().contains(text))
                        .findFirst()
                        .orElse(null);
                if (guarded != null) {
                    findings.add(new Finding(
                            Rule.UNBOUND_GUARD,
                            new Element.OfTransition(Element.ModelRole.NEW, guarded),
                            "guard [" + text + "] of " + guarded + " is not bound",
                            "call guard(\"" + text + "\", ...) in registerNewFunctions"));
                }
            }
        }
    }
}
