package org.evoloop.learn;

import org.evoloop.converter.Analysis;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.jspecify.annotations.Nullable;

/**
 * Lets no event of a learner be decided twice. A device that reports another state while an event is being sent may have
 * acted by itself, so a converter would send the event again; to a learner, one press would look like two.
 *
 * <p>Threading: as every analyze component.
 *
 * @since 0.1
 */
public final class OnceAnalyze extends EventAnalyze {
    private @Nullable Occurrence last;

    /** The component. */
    public OnceAnalyze() {
        super("Once");
    }

    @Override
    protected @Nullable Analysis analyze(Occurrence occurrence) {
        if (occurrence.equals(last)) {
            return refuse(occurrence, "the device told another state while it was being sent");
        }
        if (occurrence instanceof Occurrence.Heard heard
                && heard.source() == Source.CONTROLLER
                && !LookExecute.isOne(heard.event().name())) {
            last = occurrence;
        }
        return super.analyze(occurrence);
    }
}
