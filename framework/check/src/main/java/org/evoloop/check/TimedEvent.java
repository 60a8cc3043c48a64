package org.evoloop.check;

import org.evoloop.evolution.Configuration;

/**
 * Something that happens at a time, and where it leads.
 *
 * <p>Threading: immutable.
 *
 * @param atNanos since the start
 * @param what the event, with who raised it, or what else happens
 * @param after where both models stand then
 * @param step the event that is on its way to the device then; empty if none is
 * @since 0.1
 */
public record TimedEvent(long atNanos, String what, Configuration after, String step) {}
