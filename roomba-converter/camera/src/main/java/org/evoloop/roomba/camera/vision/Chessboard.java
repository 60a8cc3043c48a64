package org.evoloop.roomba.camera.vision;

/**
 * A chessboard to calibrate with.
 *
 * @param columns of inner corners, where four squares meet
 * @param rows of inner corners
 * @param squareMm side of a square, in mm
 * @since 0.1
 */
public record Chessboard(int columns, int rows, double squareMm) {}
