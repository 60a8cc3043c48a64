package org.evoloop.roomba.session;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.link.MemoryLink;

/** Cables in memory, one for each time a session plugs in; their other end says only what a test lets it say. */
final class Cables {
    /** The baud rate of each. */
    final List<Integer> bauds = new ArrayList<>();

    private final List<MemoryLink.Pair> all = new ArrayList<>();
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();

    Link plugIn(int baud) {
        MemoryLink.Pair fresh = MemoryLink.pair();
        fresh.robot().open(new Link.Receiver() {
            @Override
            public void received(byte[] buffer, int length) {
                heard.write(buffer, 0, length);
            }

            @Override
            public void lost(LinkException cause) {
                // The robot's side does not mind.
            }
        });
        bauds.add(baud);
        all.add(fresh);
        return fresh.converter();
    }

    /** The session's ends of all cables. */
    List<MemoryLink> ends() {
        return all.stream().map(MemoryLink.Pair::converter).toList();
    }

    private MemoryLink.Pair current() {
        return all.get(all.size() - 1);
    }

    void say(byte[] bytes) {
        current().robot().send(bytes);
    }

    void hangUp() {
        current().converter().hangUp();
    }

    void stopReading() {
        current().robot().setReading(false);
    }

    /** What the robot has heard since the last look. */
    byte[] heard() {
        byte[] bytes = heard.toByteArray();
        heard.reset();
        return bytes;
    }
}
