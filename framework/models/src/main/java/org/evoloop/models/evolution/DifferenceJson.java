package org.evoloop.models.evolution;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.evolution.ModelDifference.Parts;
import org.evoloop.models.format.Json;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** A difference as JSON, in the shape that docs/models.md promises: components are the keys, in this order. */
public record DifferenceJson(
        Ends machines, Ends initial, Names states, Names events, Transitions transitions, List<Use> device) {

    /** A value of each model. */
    public record Ends(String original, @JsonProperty("new") String evolved) {}

    public record Names(List<String> kept, List<String> added, List<String> removed) {
        static <T> Names of(Parts<T> parts) {
            return new Names(texts(parts.kept()), texts(parts.added()), texts(parts.removed()));
        }

        private static <T> List<String> texts(List<T> parts) {
            return parts.stream().map(Object::toString).toList();
        }
    }

    public record Transitions(
            List<TransitionJson> kept,
            List<TransitionJson> added,
            List<Rerouted> rerouted,
            List<TransitionJson> removed) {}

    /** A state whose device state or sends differ; an empty {@code sends} and null {@code state} where it has none. */
    public record Use(String state, Device before, Device after) {}

    public record Device(@Nullable String state, List<String> sends) {
        static Device of(DeviceUse use) {
            return new Device(Json.orNull(use.device()), use.sends());
        }
    }

    public record Rerouted(TransitionJson before, TransitionJson after) {}

    public static String write(ModelPair pair) {
        ModelDifference difference = ModelDifference.of(pair);
        return Json.write(new DifferenceJson(
                new Ends(pair.original().name(), pair.evolved().name()),
                new Ends(
                        pair.original().initial().name(),
                        pair.evolved().initial().name()),
                Names.of(difference.states()),
                Names.of(difference.events()),
                new Transitions(
                        all(difference.transitions().kept()),
                        all(difference.transitions().added()),
                        difference.rerouted().stream()
                                .map(both ->
                                        new Rerouted(TransitionJson.of(both.before()), TransitionJson.of(both.after())))
                                .toList(),
                        all(difference.transitions().removed())),
                difference.uses().stream()
                        .map(change ->
                                new Use(change.state().name(), Device.of(change.before()), Device.of(change.after())))
                        .toList()));
    }

    private static List<TransitionJson> all(List<Transition> transitions) {
        return transitions.stream().map(TransitionJson::of).toList();
    }
}
