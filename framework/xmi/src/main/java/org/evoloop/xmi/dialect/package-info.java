/**
 * Shared by all dialects: a bounded parser that knows its line, the document head by which dialects are recognised, and
 * the list of problems. A new dialect implements {@link org.evoloop.xmi.dialect.XmiDialect} in a sibling package and is
 * registered in {@code ModelFile}.
 *
 * <p>This package may use {@code org.evoloop.statechart} and {@code org.evoloop.statemachine}; not the dialects.
 */
@NullMarked
package org.evoloop.xmi.dialect;

import org.jspecify.annotations.NullMarked;
