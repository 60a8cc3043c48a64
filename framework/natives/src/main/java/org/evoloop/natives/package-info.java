/**
 * How the libraries with native parts, JNA and jSerialComm, are loaded: unpacked where nobody but this process's user can
 * write, and from nowhere else. With JNA come pseudo-terminals, by which a serial port is tested and a device simulated.
 *
 * <p>This package uses no other; whoever uses one of those libraries comes through here first.
 */
@NullMarked
package org.evoloop.natives;

import org.jspecify.annotations.NullMarked;
