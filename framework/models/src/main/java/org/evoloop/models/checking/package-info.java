/**
 * The output of {@code check}: findings with their places in the files, as text, as JSON, and as pictures of the events
 * that lead to them.
 *
 * <p>This package may use {@code statemachine}, {@code statechart}, {@code evolution} of the framework, and {@code
 * chart}, {@code diagram} and {@code format}. It does no I/O; the rules belong to the framework.
 */
@NullMarked
package org.evoloop.models.checking;

import org.jspecify.annotations.NullMarked;
