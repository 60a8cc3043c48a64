/**
 * Finds out what other models would have decided: gives the same events to a core whose directives are not carried out.
 */
@NullMarked
package org.evoloop.rehearsal;

import org.jspecify.annotations.NullMarked;
