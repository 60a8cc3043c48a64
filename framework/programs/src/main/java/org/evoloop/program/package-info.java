/**
 * What Evoloop's own programs have in common: how they tell their users of a mistake, and how they draw. It uses
 * nothing of the framework.
 */
@NullMarked
package org.evoloop.program;

import org.jspecify.annotations.NullMarked;
