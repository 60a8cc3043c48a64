package org.evoloop.check.timing;

import org.evoloop.statemachine.Event;

/**
 * What follows while the converter runs when a time property is violated.
 *
 * <p>Threading: immutable.
 *
 * @param property its name
 * @param event of the new model, which is raised then
 * @since 0.1
 */
public record Reaction(String property, Event event) {}
