/**
 * A controller or a device that exchanges lines of text: {@link org.evoloop.line.LineConnection} maintains the
 * connection, {@link org.evoloop.line.LineMonitor} and {@link org.evoloop.line.LineExecute} are the components.
 *
 * <p>It uses the core.
 */
@NullMarked
package org.evoloop.line;

import org.jspecify.annotations.NullMarked;
