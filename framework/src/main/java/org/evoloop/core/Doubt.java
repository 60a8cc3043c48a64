package org.evoloop.core;

import org.evoloop.evolution.Step;

/**
 * That nobody knows for sure where the device is.
 *
 * <p>Threading: immutable.
 *
 * @param why for people
 * @param number the occurrence in whose conversion it arose
 * @param step the step of which nobody knows whether or when it had its effect
 * @param stepsBefore how many steps had been sent before
 */
public record Doubt(String why, long number, Step step, long stepsBefore) {}
