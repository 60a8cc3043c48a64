package org.evoloop.roomba.session;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.link.Link;
import org.evoloop.link.MemoryLink;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFrame;
import org.evoloop.time.ManualClock;

/** Cables in memory, one for each time a session plugs in; their other end says only what a test lets it say. */
final class Cables {
    /** The baud rate of each. */
    final List<Integer> bauds = new ArrayList<>();

    private final List<MemoryLink.Pair> all = new ArrayList<>();

    /** Who reads what the cables say. */
    private Runnable reader = () -> {};

    /** The session that plugs these cables in and has no thread to read them. */
    RoombaSession readBy(RoombaSession session) {
        reader = session::poll;
        return session;
    }

    Link plugIn(int baud) {
        MemoryLink.Pair fresh = MemoryLink.pair();
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
        current().device().send(bytes);
        reader.run();
    }

    /** The robot shows this so many times, 15 ms apart. */
    void show(int frames, SensorValues values, ManualClock clock) {
        for (int frame = 0; frame < frames; frame++) {
            say(StreamFrame.encode(RoombaSession.STREAM, values::value));
            clock.advance(Duration.ofMillis(15));
        }
    }

    /** These commands as they go over a cable. */
    static byte[] bytes(Command... commands) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (Command command : commands) {
            all.writeBytes(command.bytes());
        }
        return all.toByteArray();
    }

    void hangUp() {
        current().converter().hangUp();
        reader.run();
    }

    void stopReading() {
        current().device().setReading(false);
    }

    /** What the robot has heard since the last look. */
    byte[] heard() {
        byte[] buffer = new byte[1_024];
        ByteArrayOutputStream heard = new ByteArrayOutputStream();
        for (MemoryLink.Pair cable : all) {
            for (int length = cable.device().receive(buffer);
                    length > 0;
                    length = cable.device().receive(buffer)) {
                heard.write(buffer, 0, length);
            }
        }
        return heard.toByteArray();
    }
}
