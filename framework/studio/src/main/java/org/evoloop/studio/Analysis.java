package org.evoloop.studio;

import org.evoloop.payload.JsonObject;

/**
 * What a pair of models means, each answer in the shape that the page expects.
 *
 * <p>Errors: a {@link MistakeException} for a text that cannot be read, and a {@link RequestException} for a request
 * that makes no sense.
 *
 * <p>Threading: called by several threads at once.
 */
public interface Analysis {

    /** Both models as pictures; a model with a mistake is only that mistake. */
    JsonObject draw(Pair pair, View view);

    /**
     * The findings of both models.
     *
     * @param properties of the new model
     */
    JsonObject check(Pair pair, Written properties);

    /**
     * What the converter does for a transition of the new model.
     *
     * @param guard of the transition; empty for none
     */
    JsonObject plan(Pair pair, String state, String event, String guard);

    /** What becomes of each pair of states if other models replace the running ones. */
    JsonObject migrate(Pair running, Pair next);

    /** Whether a property holds, and if it does not, what shows that. */
    JsonObject property(Pair pair, String property);

    /**
     * The properties of a new model, as text.
     *
     * @param path of their file, for messages
     * @param text empty for none
     */
    record Written(String path, String text) {}

    /** How a machine is drawn. */
    record View(Direction direction, Detail detail, String around) {}

    /** Where most arrows lead. */
    enum Direction {
        DOWN,
        RIGHT
    }

    /** How much is drawn. */
    enum Detail {
        /** Everything. */
        ALL,
        /** Composite states closed, and parallel arrows joined. */
        OVERVIEW,
        /** A state, and where it leads. */
        AROUND
    }
}
