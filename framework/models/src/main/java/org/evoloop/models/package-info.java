/**
 * The command {@code evoloop models}: reads the files, asks the rooms inside this package, and prints what they say.
 *
 * <p>This room may use all others of the tool and {@code xmi}.
 */
@NullMarked
package org.evoloop.models;

import org.jspecify.annotations.NullMarked;
