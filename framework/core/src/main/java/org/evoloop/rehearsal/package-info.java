/** What other models would have made of what a converter is told: the same events, told to a core that performs nothing. */
@NullMarked
package org.evoloop.rehearsal;

import org.jspecify.annotations.NullMarked;
