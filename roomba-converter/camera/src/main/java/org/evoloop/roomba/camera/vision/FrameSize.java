package org.evoloop.roomba.camera.vision;

/**
 * The size of frames, in pixels.
 *
 * @since 0.1
 */
public record FrameSize(int width, int height) {
    /** 640 by 480 pixels. */
    public static final FrameSize DEFAULT = new FrameSize(640, 480);

    @Override
    public String toString() {
        return width + "x" + height;
    }
}
