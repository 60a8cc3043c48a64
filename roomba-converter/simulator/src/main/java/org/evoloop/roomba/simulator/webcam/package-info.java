/**
 * The simulated robot's camera for programs and browsers: its pictures, served as motion JPEG over HTTP on this machine
 * only, and simulated camera faults.
 *
 * <p>This package may use {@code simulator.eye}, {@code simulator.robot} and {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.webcam;

import org.jspecify.annotations.NullMarked;
