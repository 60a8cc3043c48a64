/**
 * The command {@code evoloop models}: reads the files, calls the packages inside this one, and prints their results.
 *
 * <p>This package may use all others of the tool and {@code xmi}.
 */
@NullMarked
package org.evoloop.models;

import org.jspecify.annotations.NullMarked;
