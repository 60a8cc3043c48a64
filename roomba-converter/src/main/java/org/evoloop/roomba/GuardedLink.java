package org.evoloop.roomba;

import java.util.function.BooleanSupplier;
import org.evoloop.link.ForwardingLink;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.link.LinkException.Fault;
import org.jspecify.annotations.Nullable;

/**
 * A link that sends nothing after the guard process has stopped the robot; it is then lost, and the session reconnects.
 */
final class GuardedLink extends ForwardingLink {
    private final BooleanSupplier maySend;
    private volatile @Nullable LinkException lost;

    /** @param maySend evaluated before each command */
    GuardedLink(Link link, BooleanSupplier maySend) {
        super(link);
        this.maySend = maySend;
    }

    /** Reports the link as lost because the guard process has stopped the robot. */
    void lose(String why) {
        lost = new LinkException(Fault.OVERRULED, description() + ": " + why);
        close();
    }

    @Override
    public int receive(byte[] buffer) {
        int length = super.receive(buffer);
        return lost == null ? length : ENDED;
    }

    @Override
    public @Nullable LinkException loss() {
        LinkException overruled = lost;
        return overruled == null ? super.loss() : overruled;
    }

    @Override
    public void send(byte[] bytes) {
        LinkException overruled = lost;
        if (overruled != null) {
            throw overruled;
        }
        if (!maySend.getAsBoolean()) {
            throw new LinkException(Fault.OVERRULED, description() + ": this program was frozen; nothing is sent");
        }
        super.send(bytes);
    }
}
