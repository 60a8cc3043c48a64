package org.evoloop.roomba.simulator.eye;

import java.util.Arrays;
import java.util.List;
import org.evoloop.roomba.simulator.room.Finish;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;

/** A picture with accessors for tests. */
record Shot(CameraImage picture) {
    static final Room PLAIN = Room.of(List.of(), null, Pose.ORIGIN);

    static Shot of(EyeOptions options, Room room) {
        return new Shot(new Eye(options).render(room, Pose.ORIGIN, 0, 0));
    }

    static EyeOptions with(Effects effects) {
        return EyeOptions.defaults().withEffects(effects);
    }

    /** A rectangle's four corners. */
    static Shape box(Shape.Kind kind, double leftMm, double bottomMm, double rightMm, double topMm, Finish finish) {
        return new Shape(
                kind,
                List.of(
                        new Point(leftMm, bottomMm),
                        new Point(rightMm, bottomMm),
                        new Point(rightMm, topMm),
                        new Point(leftMm, topMm)),
                finish);
    }

    /** The green value, which is as good as gray. */
    int gray(int x, int y) {
        return channel(x, y, 1);
    }

    /** 0xRRGGBB. */
    int rgb(int x, int y) {
        return channel(x, y, 2) << 16 | channel(x, y, 1) << 8 | channel(x, y, 0);
    }

    private int channel(int x, int y, int channel) {
        return picture.bgr()[(y * picture.widthPx() + x) * 3 + channel] & 0xFF;
    }

    boolean isLike(Shot other) {
        return Arrays.equals(picture.bgr(), other.picture().bgr());
    }
}
