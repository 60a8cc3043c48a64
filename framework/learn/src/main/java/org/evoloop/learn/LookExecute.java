package org.evoloop.learn;

import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Step;

/**
 * Lets the converter ask the device where it is: it sends nothing, and says that it does not know whether that had an effect.
 *
 * <p>Threading: as every execute component.
 *
 * @since 0.1
 */
public final class LookExecute extends EventExecute {
    /** The event; the models have a loop for it in every state. */
    public static final String LOOK = "look at the device";

    /** An event that begins when the answer is there, and does nothing; the models have a loop for it, too. */
    public static final String SEEN = "the device was looked at";

    /** The component. */
    public LookExecute() {
        super("Look");
    }

    /** Whether an event is one of these. */
    static boolean isOne(String event) {
        return event.equals(LOOK) || event.equals(SEEN);
    }

    @Override
    protected Set<String> sendableEvents() {
        return Set.of(LOOK, SEEN);
    }

    @Override
    protected void send(Step step) throws UnknownEffectException {
        if (step.trigger().name().equals(SEEN)) {
            return;
        }
        throw new UnknownEffectException("the device is learned, and asked where it is");
    }
}
