/** Filled in by the commits that follow. */
@NullMarked
package org.evoloop.roomba;

import org.jspecify.annotations.NullMarked;
