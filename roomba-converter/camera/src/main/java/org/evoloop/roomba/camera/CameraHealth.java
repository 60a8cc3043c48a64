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
        /** It was asked to open and has shown nothing yet. */
        OPENING,
        /** Frames come. */
        SEEING,
        /** It is there and sends nothing, or nothing that can be read. */
        STALLED,
        /** It is not there; it is tried again. */
        GONE,
        /** Nobody wants it any more. */
        CLOSED
    }

    /** The camera works. */
    public static final CameraHealth SEEING = new CameraHealth(Condition.SEEING, "");
}
