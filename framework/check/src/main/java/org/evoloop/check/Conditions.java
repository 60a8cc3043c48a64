package org.evoloop.check;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.MissingState;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** The conditions for an evolution: the paper's Definition IV.1, the same initial state, and device states that exist. */
final class Conditions {
    private final ModelPair pair;
    private final List<MissingState> missing = new ArrayList<>();
    private final List<Finding> findings = new ArrayList<>();

    Conditions(ModelPair pair) {
        this.pair = pair;
    }

    List<Finding> findings() {
        for (ModelPair.Violation violation : pair.violations()) {
            if (violation instanceof ModelPair.Violation.MissingEvent event) {
                missing(event.event());
            } else if (violation instanceof MissingState state) {
                missing.add(state);
            }
        }
        List<MissingState> beside = missing.stream()
                .filter(state -> state.matter() == MissingState.Matter.BESIDE_REGION)
                .toList();
        if (beside.size() > 1) {
            // A region drawn beside one of the device's states is beside all of them, so it is reported once.
            findings.add(besideOneRegion(beside));
        }
        missing.stream()
                .filter(state -> beside.size() < 2 || !beside.contains(state))
                .forEach(state -> findings.add(finding(state, state.message())));
        initial();
        pair.deviceStateProblems()
                .forEach(problem -> findings.add(new Finding(
                        Rule.DEVICE_STATE,
                        new Element.OfState(Element.ModelRole.NEW, problem.state()),
                        problem.message(),
                        problem.remedy())));
        return findings;
    }

    private void missing(Event event) {
        findings.add(new Finding(
                Rule.CONDITION_1,
                new Element.OfEvent(Element.ModelRole.ORIGINAL, event),
                "event " + event + " of the original model is missing in the new model",
                "use it there under the same name, capital letters and guards included"));
    }

    private static Finding finding(MissingState state, String message) {
        return new Finding(
                Rule.CONDITION_2,
                new Element.OfState(Element.ModelRole.ORIGINAL, state.state()),
                message,
                state.matter().remedy());
    }

    private static Finding besideOneRegion(List<MissingState> beside) {
        Set<State> instead = new LinkedHashSet<>();
        beside.forEach(state -> instead.addAll(state.instead()));
        String states = beside.stream().map(state -> state.state().name()).collect(Collectors.joining(", "));
        return finding(
                beside.get(0),
                "states " + states + " of the original model stand beside another region in the new model: "
                        + instead.stream().map(State::name).limit(4).collect(Collectors.joining(", "))
                        + (instead.size() > 4 ? " and more" : ""));
    }

    private void initial() {
        State device = pair.original().initial();
        State system = pair.evolved().initial();
        // If the device's initial state is missing, that has already been reported.
        if (!pair.deviceStates(system).contains(device)
                && missing.stream().noneMatch(state -> state.state().equals(device))) {
            findings.add(new Finding(
                    Rule.INITIAL_DIFFERS,
                    new Element.OfState(Element.ModelRole.NEW, system),
                    "the new model starts in " + system + ", the device in " + device,
                    "let the new model start in " + device));
        }
    }
}
