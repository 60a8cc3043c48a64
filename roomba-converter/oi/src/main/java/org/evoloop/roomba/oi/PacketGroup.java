package org.evoloop.roomba.oi;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A sequence of packets with one id (specification, "Sensor Packet Membership Table").
 *
 * @since 0.1
 */
public enum PacketGroup implements PacketId {
    /** {@link Packet#BUMPS_AND_WHEEL_DROPS} to {@link Packet#BATTERY_CAPACITY}. */
    GROUP_0(0, Packet.BUMPS_AND_WHEEL_DROPS, Packet.BATTERY_CAPACITY),
    /** {@link Packet#BUMPS_AND_WHEEL_DROPS} to {@link Packet#UNUSED_16}. */
    GROUP_1(1, Packet.BUMPS_AND_WHEEL_DROPS, Packet.UNUSED_16),
    /** {@link Packet#INFRARED_OMNI} to {@link Packet#ANGLE}. */
    GROUP_2(2, Packet.INFRARED_OMNI, Packet.ANGLE),
    /** {@link Packet#CHARGING_STATE} to {@link Packet#BATTERY_CAPACITY}. */
    GROUP_3(3, Packet.CHARGING_STATE, Packet.BATTERY_CAPACITY),
    /** {@link Packet#WALL_SIGNAL} to {@link Packet#CHARGING_SOURCES}. */
    GROUP_4(4, Packet.WALL_SIGNAL, Packet.CHARGING_SOURCES),
    /** {@link Packet#OI_MODE} to {@link Packet#REQUESTED_LEFT_VELOCITY}. */
    GROUP_5(5, Packet.OI_MODE, Packet.REQUESTED_LEFT_VELOCITY),
    /** {@link Packet#BUMPS_AND_WHEEL_DROPS} to {@link Packet#REQUESTED_LEFT_VELOCITY}. */
    GROUP_6(6, Packet.BUMPS_AND_WHEEL_DROPS, Packet.REQUESTED_LEFT_VELOCITY),
    /** {@link Packet#BUMPS_AND_WHEEL_DROPS} to {@link Packet#STASIS}. */
    GROUP_100(100, Packet.BUMPS_AND_WHEEL_DROPS, Packet.STASIS),
    /** {@link Packet#LEFT_ENCODER} to {@link Packet#STASIS}. */
    GROUP_101(101, Packet.LEFT_ENCODER, Packet.STASIS),
    /** {@link Packet#LIGHT_BUMP_LEFT_SIGNAL} to {@link Packet#LIGHT_BUMP_RIGHT_SIGNAL}. */
    GROUP_106(106, Packet.LIGHT_BUMP_LEFT_SIGNAL, Packet.LIGHT_BUMP_RIGHT_SIGNAL),
    /** {@link Packet#LEFT_MOTOR_CURRENT} to {@link Packet#STASIS}. */
    GROUP_107(107, Packet.LEFT_MOTOR_CURRENT, Packet.STASIS);

    private final int id;
    private final int firstId;
    private final int lastId;
    private final int size;

    PacketGroup(int id, Packet first, Packet last) {
        this.id = id;
        this.firstId = first.id();
        this.lastId = last.id();
        this.size = PacketId.size(members());
    }

    static @Nullable PacketGroup at(int id) {
        for (PacketGroup group : values()) {
            if (group.id == id) {
                return group;
            }
        }
        return null;
    }

    @Override
    public int id() {
        return id;
    }

    @Override
    public int size() {
        return size;
    }

    @Override
    public List<Packet> members() {
        return Packet.ALL.subList(firstId - Packet.FIRST_ID, lastId - Packet.FIRST_ID + 1);
    }
}
