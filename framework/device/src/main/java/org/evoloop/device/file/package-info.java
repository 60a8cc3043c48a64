/**
 * The text of a device file: a tree whose every value knows its line ({@link org.evoloop.device.file.Section}), and the
 * mistakes that were found in it. It knows nothing of devices.
 */
@NullMarked
package org.evoloop.device.file;

import org.jspecify.annotations.NullMarked;
