/** Filled in by the commits that follow. */
@NullMarked
package org.evoloop.lightbulb;

import org.jspecify.annotations.NullMarked;
