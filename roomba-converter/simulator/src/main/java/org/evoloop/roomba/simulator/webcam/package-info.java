/**
 * The simulated robot's camera as programs and browsers find it: pictures of the eye, served as motion JPEG over HTTP
 * on this machine alone, and what goes wrong with cameras.
 *
 * <p>This package may use {@code simulator.eye}, {@code simulator.robot} and {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.webcam;

import org.jspecify.annotations.NullMarked;
