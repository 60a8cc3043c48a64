package org.evoloop.roomba.simulator.eye;

/**
 * A picture taken by the camera.
 *
 * @param bgr one byte each for blue, green and red, row by row from the top left; the receiver may change it
 * @since 0.1
 */
@SuppressWarnings("ArrayRecordComponent") // Hundreds of pictures are made per second; copies would double the work.
public record CameraImage(int widthPx, int heightPx, byte[] bgr) {}
