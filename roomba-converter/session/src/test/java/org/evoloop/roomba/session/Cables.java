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

/** Cables in memory, one for each time a session connects; their other end sends only what a test makes it send. */
final class Cables {
    /** The baud rate of each. */
    final List<Integer> bauds = new ArrayList<>();

    private final List<MemoryLink.Pair> all = new ArrayList<>();

    /** Reads what the cables deliver. */
    private Runnable reader = () -> {};

    /** Makes a session without threads read these cables. */
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

    /** The robot sends this many frames with these values, 15 ms apart. */
    void show(int frames, SensorValues values, ManualClock clock) {
        for (int frame = 0; frame < frames; frame++) {
            showAtOnce(1, values);
            clock.advance(Duration.ofNanos(Frames.APART_NANOS));
        }
    }

    /** The robot has sent this many frames with these values, which were held up and come together. */
    void showAtOnce(int frames, SensorValues values) {
        for (int frame = 0; frame < frames; frame++) {
            say(StreamFrame.encode(RoombaSession.STREAM, values::value));
        }
    }

    /** The bytes of these commands. */
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

    /** The bytes that the robot has received since the last call. */
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
