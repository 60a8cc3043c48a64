/**
 * The file that an evolution's author writes beside its models ({@link org.evoloop.check.properties.PropertyFile}):
 * properties, assumptions about time, and rules that are switched off.
 *
 * <p>This package may use {@code check} and {@code check.temporal} and {@code check.timing}. It reads no files itself.
 */
@NullMarked
package org.evoloop.check.properties;

import org.jspecify.annotations.NullMarked;
