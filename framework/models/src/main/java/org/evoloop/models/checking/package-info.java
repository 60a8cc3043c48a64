/**
 * What {@code check} says: findings with their places in the files, for people, for programs, and as pictures of the
 * events that lead to them.
 *
 * <p>This room may use {@code statemachine}, {@code statechart}, {@code evolution} of the framework, and {@code chart},
 * {@code diagram} and {@code format}. It is pure; the rules are the framework's.
 */
@NullMarked
package org.evoloop.models.checking;

import org.jspecify.annotations.NullMarked;
