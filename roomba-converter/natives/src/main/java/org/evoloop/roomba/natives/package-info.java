/**
 * How the libraries with native parts, JNA and jSerialComm, are loaded: unpacked where nobody but this process's user
 * can write, and from nowhere else.
 *
 * <p>This room uses no other; whoever uses one of those libraries comes through here first.
 */
@NullMarked
package org.evoloop.roomba.natives;

import org.jspecify.annotations.NullMarked;
