/**
 * The commands for device files, which run a file as a program, or check it together with its models.
 *
 * <p>It uses device files, and the commands for models.
 */
@NullMarked
package org.evoloop.models.device;

import org.jspecify.annotations.NullMarked;
