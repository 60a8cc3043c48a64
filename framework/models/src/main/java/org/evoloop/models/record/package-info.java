/**
 * What the records of a journal look like: a line for people, JSON for programs, and a database; and what other models
 * would have made of its events.
 *
 * <p>This room may use {@code org.evoloop.models.format}, {@code chart} and {@code diagram}, and {@code
 * org.evoloop.journal} and {@code check.temporal}.
 */
@NullMarked
package org.evoloop.models.record;

import org.jspecify.annotations.NullMarked;
