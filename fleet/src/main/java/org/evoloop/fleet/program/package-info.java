/** Code shared by the fleet's programs. It may use {@code stream} and {@code wire}. */
@NullMarked
package org.evoloop.fleet.program;

import org.jspecify.annotations.NullMarked;
