package org.evoloop.roomba.simulator.eye;

/**
 * A picture taken by the camera.
 *
 * @param bgr a byte each for blue, green and red, row by row from the top left; whoever has the picture may change it
 * @since 0.1
 */
@SuppressWarnings("ArrayRecordComponent") // Hundreds of pictures are made in a second; copies would double the work.
public record Picture(int widthPx, int heightPx, byte[] bgr) {}
