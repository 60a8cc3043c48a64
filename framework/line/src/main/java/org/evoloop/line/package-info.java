/**
 * A controller or a device that speaks in lines of text: {@link org.evoloop.line.LineConnection} keeps the connection,
 * {@link org.evoloop.line.LineMonitor} and {@link org.evoloop.line.LineExecute} are the components.
 *
 * <p>It uses the core.
 */
@NullMarked
package org.evoloop.line;

import org.jspecify.annotations.NullMarked;
