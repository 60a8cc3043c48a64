package org.evoloop.converter.attachment;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/** What analyze and plan components are attached to. */
public interface DecisionHost {
    /** The decision for {@code occurrence} now; null if it is no longer in progress. */
    @Nullable
    Decision decide(Occurrence occurrence);

    /**
     * Whether the record is right only if {@code occurrence} is carried out: it asks where the device is, or brings it
     * where the new model is, after other models have taken over or a plan for it has failed in the middle.
     */
    boolean keepsRecord(Occurrence occurrence);

    /** The states of device and evolved system. */
    Configuration configuration();
}
