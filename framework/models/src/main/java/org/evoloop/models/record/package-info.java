/**
 * What the records of a journal look like: a line for people, JSON for programs, and a database.
 *
 * <p>This room may use {@code org.evoloop.models.format} and {@code org.evoloop.journal}.
 */
@NullMarked
package org.evoloop.models.record;

import org.jspecify.annotations.NullMarked;
