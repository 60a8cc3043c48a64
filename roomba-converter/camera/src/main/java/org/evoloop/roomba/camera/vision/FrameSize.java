package org.evoloop.roomba.camera.vision;

/** How large frames are, in pixels. */
public record FrameSize(int width, int height) {
    public static final FrameSize DEFAULT = new FrameSize(640, 480);

    @Override
    public String toString() {
        return width + "x" + height;
    }
}
