/**
 * What every dialect is made of: a bounded parser that knows its line, the head that tells dialects apart, and the list
 * of problems. A new dialect implements {@link org.evoloop.xmi.dialect.XmiDialect} in a package beside this one and
 * takes a line in {@code XmiFile}.
 *
 * <p>This package may use {@code org.evoloop.statechart} and {@code org.evoloop.statemachine}; not the dialects.
 */
@NullMarked
package org.evoloop.xmi.dialect;

import org.jspecify.annotations.NullMarked;
