package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;
import static org.evoloop.statechart.Draw.state;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;

/**
 * If the new model only adds histories, the device is always in the drawn states of the new model's chart: one
 * interpreter runs the new chart, another one is the device and receives what the decisions send.
 */
class AddedHistoryTest {
    private static final int CHARTS = 60;
    private static final int EVENTS = 60;

    /** How often the device needed more than one event. */
    private int detours;

    @Test
    void shouldLeadTheDeviceToWhatTheNewModelRemembers() {
        Statechart evolved = chart(
                region(
                        initial("i"),
                        state("C", region(initial("j"), state("On"), state("Off"), pseudo("H", Kind.SHALLOW_HISTORY))),
                        state("Out")),
                arc("i C"),
                arc("j On"),
                arc("On Off p"),
                arc("Off On p"),
                arc("C Out z"),
                arc("Out H h"));
        Flattening original = Flattening.of(Forgetful.copy(evolved));
        ModelPair pair = new ModelPair(original.machine(), Flattening.flatten(evolved));
        pair.requireValid();
        DecisionTable table = DecisionTable.compile(pair, device(pair));

        Configuration at = pair.initial();
        List<String> sent = new ArrayList<>();
        for (String event : List.of("p", "z", "h", "p")) {
            Decision decision = table.decide(at, new Event(event), false);
            assertThat(decision).isInstanceOf(Decision.ExistingState.class);
            decision.steps().forEach(step -> sent.add(step.toString()));
            at = decision.after();
        }

        assertThat(pair.evolved().states()).extracting(State::name).contains("Out [history Off]");
        assertThat(sent)
                .containsExactly("On --p--> Off", "Off --z--> Out", "Out --h--> On", "On --p--> Off", "Off --p--> On");
    }

    @Test
    void shouldKeepTheDeviceWhereTheNewChartIs() {
        int compared = 0;
        for (long seed = 1; compared < CHARTS; seed++) {
            Optional<Statechart> evolved = Forgetful.busier(RandomChart.draw(new Random(seed), 4 + (int) (seed % 3)));
            if (evolved.isPresent() && compare(seed, Forgetful.copy(evolved.get()), evolved.get())) {
                compared++;
            }
            assertThat(seed).as("few charts give an evolution").isLessThan(100 * CHARTS);
        }
        assertThat(detours).as("events that send the device on a detour").isGreaterThan(CHARTS / 2);
    }

    private static DeviceEvents device(ModelPair pair) {
        return new DeviceEvents(pair.original().triggers(), Set.of())
                .withBoundGuards(pair.original().guards());
    }

    private boolean compare(long seed, Statechart original, Statechart evolved) {
        Flattening flatOriginal = Flattening.of(original);
        Flattening flatEvolved = Flattening.of(evolved);
        if (!flatOriginal.problems().isEmpty() || !flatEvolved.problems().isEmpty()) {
            return false;
        }
        ModelPair pair = new ModelPair(flatOriginal.machine(), flatEvolved.machine());
        if (!pair.violations().isEmpty()
                || !keys(flatOriginal, pair.original(), pair.original().initial())
                        .equals(keys(flatEvolved, pair.evolved(), pair.evolved().initial()))) {
            return false;
        }
        Set<List<String>> known = Set.copyOf(pair.original().states().stream()
                .map(state -> keys(flatOriginal, pair.original(), state))
                .toList());
        for (State state : pair.evolved().states()) {
            assertThat(pair.isNew(state))
                    .as("seed %d: %s is new", seed, state)
                    .isEqualTo(!known.contains(keys(flatEvolved, pair.evolved(), state)));
        }
        walk(
                "seed " + seed + " of " + pair.evolved(),
                pair,
                flatEvolved,
                new Interpreter(original),
                new Interpreter(evolved));
        return true;
    }

    private void walk(String what, ModelPair pair, Flattening flatEvolved, Interpreter device, Interpreter wanted) {
        Random random = new Random(what.hashCode());
        DecisionTable table = DecisionTable.compile(pair, device(pair));
        device.start(guard -> true);
        wanted.start(guard -> true);
        Configuration at = pair.initial();
        List<String> story = new ArrayList<>();
        for (int i = 0; i < EVENTS; i++) {
            List<Transition> enabled = pair.evolved().transitionsFrom(at.evolved());
            if (enabled.isEmpty()) {
                return;
            }
            Event trigger = enabled.get(random.nextInt(enabled.size())).event().trigger();
            Event event = table.resolve(at, trigger, guard -> true);
            Decision decision = table.decide(at, event, false);
            if (decision instanceof Decision.Impossible
                    || decision.steps().stream().anyMatch(step -> !table.isOpen(step, guard -> true))) {
                continue;
            }
            story.add(event + " " + decision.steps());
            for (Step step : decision.steps()) {
                device.dispatch(Drawing.drawn(step.trigger().name()), guard -> true);
            }
            wanted.dispatch(Drawing.drawn(trigger.name()), guard -> true);
            at = decision.after();
            assertThat(wanted.leaves())
                    .as("%s, new model after %s", what, story)
                    .isEqualTo(keys(flatEvolved, pair.evolved(), at.evolved()));
            if (!pair.isNew(at.evolved())) {
                assertThat(device.leaves())
                        .as("%s, device after %s", what, story)
                        .isEqualTo(wanted.leaves());
            }
            detours += decision.steps().size() > 1 ? 1 : 0;
        }
    }

    /** @param machine the flat machine, in which some states may have other names, in the same order */
    private static List<String> keys(Flattening flattening, StateMachine machine, State state) {
        int number = List.copyOf(machine.states()).indexOf(state);
        State named = List.copyOf(flattening.machine().states()).get(number);
        return flattening.leaves().getOrDefault(named, List.of()).stream()
                .map(Vertex::key)
                .toList();
    }
}
