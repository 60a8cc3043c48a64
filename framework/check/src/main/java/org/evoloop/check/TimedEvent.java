package org.evoloop.check;

import org.evoloop.evolution.Configuration;

/**
 * An event with its time and its result.
 *
 * <p>Threading: immutable.
 *
 * @param atNanos the time since the start
 * @param what the event and its source, or whatever else happens
 * @param after the states of both models then
 * @param step the event that is being sent to the device then; empty if none is
 * @since 0.1
 */
public record TimedEvent(long atNanos, String what, Configuration after, String step) {}
