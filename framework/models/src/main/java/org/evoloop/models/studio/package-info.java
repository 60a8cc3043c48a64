/**
 * What the studio says about models: pictures, findings, plans and properties, by the rules of the other commands.
 *
 * <p>This package may use all others but the commands.
 */
@NullMarked
package org.evoloop.models.studio;

import org.jspecify.annotations.NullMarked;
