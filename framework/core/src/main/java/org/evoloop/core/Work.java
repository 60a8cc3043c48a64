package org.evoloop.core;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * The occurrence in progress: what it means, and how far its plan has been carried out.
 *
 * <p>Threading: immutable.
 *
 * @param decision null while it is being analyzed and planned
 * @param taken how many steps of the decision have been taken
 * @param effectsRun how many of its effects have been run
 * @param failedEffects what went wrong with them; empty if nothing did
 * @param sending whether the next step is on its way to the device
 * @param meanwhile what the device did by itself while the step was on its way, or while it was asked where it is
 */
public record Work(
        Pending pending,
        @Nullable Decision decision,
        int taken,
        int effectsRun,
        String failedEffects,
        boolean sending,
        List<Occurrence> meanwhile) {}
