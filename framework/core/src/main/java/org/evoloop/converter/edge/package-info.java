/**
 * A converter without its core, for a device whose events are decided elsewhere: {@link
 * org.evoloop.converter.edge.EdgeShell}.
 *
 * <p>This package may use {@code org.evoloop.converter.running} and what that uses.
 */
@NullMarked
package org.evoloop.converter.edge;

import org.jspecify.annotations.NullMarked;
