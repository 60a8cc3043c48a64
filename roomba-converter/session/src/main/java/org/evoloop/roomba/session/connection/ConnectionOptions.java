package org.evoloop.roomba.session.connection;

import java.time.Duration;
import java.util.List;
import org.evoloop.roomba.oi.PacketId;

/**
 * The options of a {@link RobotConnection}.
 *
 * @param stream the packets that the robot is to send
 * @param silenceLimit the time without a frame after which the robot counts as unreachable, in the clock's time; time in
 *     which this program was held up does not count
 * @param mayWait false if the caller controls the time: then no thread is created
 * @since 0.1
 */
public record ConnectionOptions(List<PacketId> stream, Duration silenceLimit, boolean mayWait) {}
