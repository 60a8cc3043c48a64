/**
 * A converter's project to begin with: it builds, its tests pass and it runs before its owner has written a line.
 *
 * <p>This room may use {@code statemachine}, {@code evolution} and {@code xmi} of the framework. It writes files, below
 * the directory that it is given and nowhere else.
 */
@NullMarked
package org.evoloop.models.scaffold;

import org.jspecify.annotations.NullMarked;
