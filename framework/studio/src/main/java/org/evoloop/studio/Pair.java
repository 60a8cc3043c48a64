package org.evoloop.studio;

import org.evoloop.evolution.ModelPair;

/**
 * The two models of a request.
 *
 * @param original the device as it is
 * @param evolved the device as its owner wants it
 */
public record Pair(Source original, Source evolved) {

    /**
     * Both machines, flat. Whether they go together is not checked.
     *
     * @throws MistakeException if one of them cannot be used
     */
    public ModelPair flat() {
        return new ModelPair(
                original.read(() -> original.machine().toStateMachine()),
                evolved.read(() -> evolved.machine().toStateMachine()));
    }
}
