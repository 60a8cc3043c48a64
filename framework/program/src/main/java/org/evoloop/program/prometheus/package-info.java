/** {@code /metrics} of a program's live page. */
@NullMarked
package org.evoloop.program.prometheus;

import org.jspecify.annotations.NullMarked;
