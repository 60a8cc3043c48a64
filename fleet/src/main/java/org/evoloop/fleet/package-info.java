/** The programs {@code evoloop fleet} and {@code evoloop gateway}. */
@NullMarked
package org.evoloop.fleet;

import org.jspecify.annotations.NullMarked;
