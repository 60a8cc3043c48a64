package org.evoloop.roomba;

import java.util.function.BooleanSupplier;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.link.LinkException.Fault;
import org.evoloop.roomba.link.WakeLine;
import org.jspecify.annotations.Nullable;

/**
 * A link on which nothing is sent once the guard process has stopped the robot: it is lost then, and the session connects
 * anew.
 */
final class GuardedLink implements Link {
    private final Link link;
    private final BooleanSupplier maySend;
    private volatile @Nullable LinkException lost;

    /** @param maySend is asked before each command */
    GuardedLink(Link link, BooleanSupplier maySend) {
        this.link = link;
        this.maySend = maySend;
    }

    /** The robot has been stopped by somebody else. */
    void lose(String why) {
        lost = new LinkException(Fault.OVERRULED, description() + ": " + why);
        link.close();
    }

    @Override
    public int receive(byte[] buffer) {
        int length = link.receive(buffer);
        return lost == null ? length : ENDED;
    }

    @Override
    public @Nullable LinkException loss() {
        LinkException overruled = lost;
        return overruled == null ? link.loss() : overruled;
    }

    @Override
    public void send(byte[] bytes) {
        LinkException overruled = lost;
        if (overruled != null) {
            throw overruled;
        }
        if (!maySend.getAsBoolean()) {
            throw new LinkException(Fault.OVERRULED, description() + ": this program stood still; nothing is sent");
        }
        link.send(bytes);
    }

    @Override
    public WakeLine wakeLine() {
        return link.wakeLine();
    }

    @Override
    public String description() {
        return link.description();
    }

    @Override
    public void close() {
        link.close();
    }
}
