package org.evoloop.device;

import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.converter.Effect;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.State;

/** The functions, guards, effects and costs of a device file. */
final class FileKnowledge extends StateKnowledge {
    private final Content content;

    /**
     * What a file registers.
     *
     * @param functions by state
     * @param guards by text
     * @param effects by text
     * @param costs by event
     * @param doNotPass states of the original model
     */
    record Content(
            Map<String, Function> functions,
            Map<String, Predicate<Values>> guards,
            Map<String, Effect.OfEvent> effects,
            Map<String, Integer> costs,
            Set<String> doNotPass) {}

    /**
     * The function of a state.
     *
     * @param sends the events that it may send to the device
     */
    record Function(NewFunction runs, Set<String> sends) {}

    FileKnowledge(ModelPair models, Content content) {
        super(models);
        this.content = content;
    }

    @Override
    protected void registerNewFunctions() {
        content.functions().forEach((state, function) -> {
            function(state, function.runs());
            function.sends().forEach(event -> sends(state, event));
        });
        for (State state : models().evolved().states()) {
            if (models().isNew(state)
                    && !models().whereDeviceMustBe(state).isEmpty()
                    && !FileModels.isNamed(state, models(), content.functions().keySet())) {
                function(state.name(), NewFunction.none());
            }
        }
        content.guards().forEach(this::guard);
        content.effects().forEach(this::effect);
        content.costs().forEach(this::cost);
        content.doNotPass().forEach(this::doNotPass);
    }
}
