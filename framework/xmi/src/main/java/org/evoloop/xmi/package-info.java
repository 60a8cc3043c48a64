/**
 * Reads state machines from files of modelling tools. The entry point is {@link org.evoloop.xmi.ModelFile}. Behind it,
 * each format has a {@link org.evoloop.xmi.dialect.XmiDialect} in its own package. Whatever a file contains, memory
 * stays bounded, and a problem becomes one {@link org.evoloop.statemachine.ModelException} with file, line and how to
 * fix it.
 *
 * <p>This package may use {@code org.evoloop.statechart} and {@code org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.xmi;

import org.jspecify.annotations.NullMarked;
