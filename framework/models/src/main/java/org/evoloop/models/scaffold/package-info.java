/**
 * Generates a starter project for a converter. It builds, passes its tests and runs before its owner has written any
 * code.
 *
 * <p>This package may use {@code statemachine}, {@code evolution}, {@code xmi} and {@code device} of the framework. It
 * writes files only below the given directory.
 */
@NullMarked
package org.evoloop.models.scaffold;

import org.jspecify.annotations.NullMarked;
