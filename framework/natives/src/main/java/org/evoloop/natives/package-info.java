/**
 * Loads the libraries with native parts, JNA and jSerialComm: they are unpacked where only this process's user can
 * write, and loaded from nowhere else. Also provides pseudo-terminals, with which a serial port is tested and a device
 * simulated.
 *
 * <p>This package uses no other. Every user of one of those libraries loads it through this package.
 */
@NullMarked
package org.evoloop.natives;

import org.jspecify.annotations.NullMarked;
