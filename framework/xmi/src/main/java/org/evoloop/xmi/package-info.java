/**
 * Reads state machines from files of modelling tools: one entry, {@link org.evoloop.xmi.XmiFile}, and behind it one
 * {@link org.evoloop.xmi.dialect.XmiDialect} a way of writing, each in a package of its own below this one. Whatever a
 * file holds, memory stays bounded and a problem becomes one {@link org.evoloop.statemachine.ModelException} with file,
 * line and how to fix it.
 *
 * <p>This package may use {@code org.evoloop.statechart} and {@code org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.xmi;

import org.jspecify.annotations.NullMarked;
