package org.evoloop.check.timing;

import org.evoloop.statemachine.Event;

/**
 * The reaction to the violation of a time property while the converter runs.
 *
 * <p>Threading: immutable.
 *
 * @param property the property's name
 * @param event the event of the new model that is raised then
 * @since 0.1
 */
public record Reaction(String property, Event event) {}
