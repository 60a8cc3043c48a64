package org.evoloop.roomba.oi;

import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * What an {@link InputCommand} can request by one id: a packet or a group of packets.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface PacketId permits Packet, PacketGroup {

    /** The number on the wire. */
    int id();

    /** How many bytes the robot sends for it. */
    int size();

    /** The packets that it consists of, in the order of their bytes. */
    List<Packet> members();

    /**
     * The packet or group with this id; empty for ids without a meaning in the specification. Robots of the 700 series
     * answer some of those, from 59 up.
     */
    static Optional<PacketId> of(int id) {
        return Optional.ofNullable(id >= Packet.FIRST_ID && id <= Packet.LAST_ID ? Packet.at(id) : PacketGroup.at(id));
    }

    /** How many bytes the robot sends for all of them. */
    static int size(Collection<? extends PacketId> packets) {
        int size = 0;
        for (PacketId packet : packets) {
            size += packet.size();
        }
        return size;
    }
}
