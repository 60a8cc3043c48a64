/** What the fleet's programs have in common. It may use {@code stream} and {@code wire}. */
@NullMarked
package org.evoloop.fleet.program;

import org.jspecify.annotations.NullMarked;
