package org.evoloop.models;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.evoloop.check.CheckInput;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Options for what the converter provides. What is not given is not checked. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class ConverterOptions {
    @Option(
            names = "--functions",
            split = ",",
            paramLabel = "STATE",
            description = "New states that have a registered function; checked only if given.")
    private @Nullable List<String> functions;

    @Option(
            names = "--sends",
            split = ",",
            paramLabel = "STATE=EVENT",
            description = "What functions may send besides what the new model says, as their code declares it.")
    private List<String> sends = List.of();

    @Option(
            names = "--raised",
            split = ",",
            paramLabel = "EVENT",
            description = "Events that monitors and functions raise; checked only if given.")
    private @Nullable List<String> raised;

    @Option(
            names = "--guards",
            split = ",",
            paramLabel = "GUARD",
            description = "Guards that are bound to code; checked only if given.")
    private @Nullable List<String> guards;

    @Option(
            names = "--effects",
            split = ",",
            paramLabel = "EFFECT",
            description = "Effects that are bound to code; checked only if given.")
    private @Nullable List<String> effects;

    /**
     * Adds these options to the input of the check.
     *
     * @throws IllegalArgumentException for a name that neither model has
     */
    CheckInput addTo(CheckInput models) {
        ModelPair pair = models.pair();
        CheckInput input = models;
        if (functions != null) {
            Set<String> states = KnownNames.states(pair.evolved());
            input = input.withFunctions(KnownNames.resolve("--functions", functions, states, "state of the new model"));
        }
        for (String send : sends) {
            input = sending(input, send);
        }
        if (raised != null) {
            Set<String> events = ofBoth(pair, machine -> names(machine.triggers(), Event::name));
            input = input.withRaised(KnownNames.resolve("--raised", raised, events, "event of either model"));
        }
        if (guards != null) {
            Set<String> texts = ofBoth(pair, StateMachine::guards);
            input = input.withGuards(KnownNames.resolve("--guards", guards, texts, "guard of either model"));
        }
        if (effects != null) {
            Set<String> texts = ofBoth(pair, ConverterOptions::effects);
            input = input.withEffects(KnownNames.resolve("--effects", effects, texts, "effect of either model"));
        }
        return input;
    }

    private static CheckInput sending(CheckInput input, String send) {
        int sign = send.lastIndexOf('=');
        if (sign < 0) {
            throw new IllegalArgumentException("--sends: write STATE=EVENT, not " + send);
        }
        ModelPair pair = input.pair();
        Set<String> states = KnownNames.states(pair.evolved());
        pair.original().states().forEach(state -> states.remove(state.name()));
        Set<String> events = names(pair.original().triggers(), Event::name);
        String state = only(send.substring(0, sign), states, "new state");
        return input.withSends(state, only(send.substring(sign + 1), events, "event of the original model"));
    }

    private static String only(String given, Set<String> known, String what) {
        KnownNames.resolve("--sends", List.of(given), known, what);
        return given.strip();
    }

    private static Set<String> ofBoth(ModelPair pair, Function<StateMachine, Set<String>> names) {
        Set<String> all = new LinkedHashSet<>(names.apply(pair.evolved()));
        all.addAll(names.apply(pair.original()));
        return all;
    }

    private static Set<String> effects(StateMachine machine) {
        Set<String> effects = new LinkedHashSet<>();
        machine.transitions().forEach(transition -> effects.addAll(transition.effects()));
        return effects;
    }

    private static <T> Set<String> names(Collection<T> parts, Function<T, String> name) {
        return parts.stream().map(name).collect(Collectors.toCollection(LinkedHashSet::new));
    }
}
