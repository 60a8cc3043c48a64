/**
 * The kinds of connection that every device file can have: each reads its part of the file, and makes the monitors and
 * executes of its module. They use only what {@link org.evoloop.device.ConnectionKind} offers to every kind.
 */
@NullMarked
package org.evoloop.device.connection;

import org.jspecify.annotations.NullMarked;
