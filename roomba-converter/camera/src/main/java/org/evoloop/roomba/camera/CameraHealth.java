package org.evoloop.roomba.camera;

/**
 * The health of a camera.
 *
 * @param reason the problem and its remedy, for people; empty while it works
 * @since 0.1
 */
public record CameraHealth(Condition state, String reason) {

    /**
     * <pre>
     *   OPENING --first frame--&gt; SEEING --no frame in time--&gt; STALLED --frame--&gt; SEEING
     *      ^                        |                             |
     *      '-- after a pause -- GONE &lt;--unplugged, given up-------'        any --close--&gt; CLOSED
     * </pre>
     */
    public enum Condition {
        /** Being opened; no frame has arrived yet. */
        OPENING,
        /** Frames arrive. */
        SEEING,
        /** The camera is open and sends no frames, or none that can be decoded. */
        STALLED,
        /** The camera is not available; it is opened again after a pause. */
        GONE,
        /** Closed by the program. */
        CLOSED
    }

    /** The camera works. */
    public static final CameraHealth SEEING = new CameraHealth(Condition.SEEING, "");
}
