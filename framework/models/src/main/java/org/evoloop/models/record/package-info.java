/**
 * A journal's records as text, as JSON and in a database, and the results of replaying its events on other models.
 *
 * <p>This package may use {@code org.evoloop.models.format}, {@code chart} and {@code diagram}, and {@code
 * org.evoloop.journal} and {@code check.temporal}.
 */
@NullMarked
package org.evoloop.models.record;

import org.jspecify.annotations.NullMarked;
