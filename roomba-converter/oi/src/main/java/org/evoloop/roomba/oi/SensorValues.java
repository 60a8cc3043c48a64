package org.evoloop.roomba.oi;

import java.util.Arrays;
import java.util.Collection;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.StringJoiner;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;

/**
 * The raw values of some packets at one moment: since some robots report codes that the specification lacks, nothing is
 * corrected here. A getter for a packet that is not among them throws {@link NoSuchElementException} with the packet's
 * id.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class SensorValues {
    private final long present;
    private final int[] values;

    private SensorValues(long present, int[] values) {
        this.present = present;
        this.values = values;
    }

    /** The values from {@code source} for these packets; it is called once for each, in order. */
    public static SensorValues of(Collection<? extends PacketId> packets, ToIntFunction<Packet> source) {
        return decode(packets, encode(packets, source));
    }

    /**
     * Reads the raw reply to {@link InputCommand.Sensors} or {@link InputCommand.QueryList}. A repeated packet has its
     * last value.
     *
     * @throws IllegalArgumentException if the number of bytes is not that of these packets
     */
    public static SensorValues decode(Collection<? extends PacketId> packets, byte[] bytes) {
        int size = PacketId.size(packets);
        Bytes.requireRange("reply to packets " + packets, bytes.length, size, size, "bytes");
        Reader reader = new Reader(bytes, 0);
        for (PacketId packet : packets) {
            reader.read(packet);
        }
        return reader.values();
    }

    /** Reads the payload, between length and checksum, of a frame whose ids and lengths are known to be right. */
    static SensorValues decodePayload(byte[] frame, int from, int end) {
        Reader reader = new Reader(frame, from);
        while (reader.offset < end) {
            reader.read(PacketId.of(Bytes.unsigned8(frame, reader.offset++)).orElseThrow());
        }
        return reader.values();
    }

    /**
     * The robot's raw reply: the bytes of these packets in their order.
     *
     * @param source asked once for each packet, in their order; a {@link SensorValues} is one by {@code values::value}
     * @throws IllegalArgumentException if a value does not fit into its packet's bytes
     */
    public static byte[] encode(Collection<? extends PacketId> packets, ToIntFunction<Packet> source) {
        byte[] bytes = new byte[PacketId.size(packets)];
        int offset = 0;
        for (PacketId packet : packets) {
            offset = encode(packet, source, bytes, offset);
        }
        return bytes;
    }

    /** Writes one packet or group and returns where the next one goes. */
    static int encode(PacketId packet, ToIntFunction<Packet> source, byte[] target, int offset) {
        int next = offset;
        for (Packet member : packet.members()) {
            member.encode(source.applyAsInt(member), target, next);
            next += member.size();
        }
        return next;
    }

    private static final class Reader {
        private final byte[] bytes;
        private final int[] values = new int[Packet.ALL.size()];
        private int offset;
        private long present;

        Reader(byte[] bytes, int offset) {
            this.bytes = bytes;
            this.offset = offset;
        }

        void read(PacketId packet) {
            for (Packet member : packet.members()) {
                values[index(member)] = member.decode(bytes, offset);
                present |= 1L << index(member);
                offset += member.size();
            }
        }

        SensorValues values() {
            return new SensorValues(present, values);
        }
    }

    private static int index(Packet packet) {
        return packet.id() - Packet.FIRST_ID;
    }

    /** A copy with this value added or replaced; the same object if it has the value already. */
    public SensorValues with(Packet packet, int value) {
        if (has(packet) && values[index(packet)] == value) {
            return this;
        }
        int[] changed = Arrays.copyOf(values, values.length);
        changed[index(packet)] = value;
        return new SensorValues(present | 1L << index(packet), changed);
    }

    /** Whether this packet is among the values. */
    public boolean has(Packet packet) {
        return (present >> index(packet) & 1) == 1;
    }

    /** The value as the robot sent it. */
    public int value(Packet packet) {
        if (!has(packet)) {
            throw new NoSuchElementException(
                    "packet " + packet.id() + " (" + packet + ") is not among the values " + this + "; ask for it");
        }
        return values[index(packet)];
    }

    private boolean bit(Packet packet, int bit) {
        return Bytes.hasBit(value(packet), bit);
    }

    /** Packet 35; empty if the robot reports a code that the specification lacks. */
    public Optional<OiMode> mode() {
        return OiMode.of(value(Packet.OI_MODE));
    }

    /** Packet 18: the buttons held down at this moment. */
    public Set<Button> buttons() {
        return Button.fromBits(value(Packet.BUTTONS));
    }

    /** Packet 18. */
    public boolean isPressed(Button button) {
        return button.isIn(value(Packet.BUTTONS));
    }

    /** Packet 7. */
    public boolean bumpRight() {
        return bit(Packet.BUMPS_AND_WHEEL_DROPS, 0);
    }

    /** Packet 7. */
    public boolean bumpLeft() {
        return bit(Packet.BUMPS_AND_WHEEL_DROPS, 1);
    }

    /** Packet 7. */
    public boolean wheelDropRight() {
        return bit(Packet.BUMPS_AND_WHEEL_DROPS, 2);
    }

    /** Packet 7. */
    public boolean wheelDropLeft() {
        return bit(Packet.BUMPS_AND_WHEEL_DROPS, 3);
    }

    /** Packet 7: either wheel hangs. */
    public boolean anyWheelDrop() {
        return wheelDropRight() || wheelDropLeft();
    }

    /** Packets 9 to 12: any of the four sensors sees a cliff. */
    public boolean anyCliff() {
        return value(Packet.CLIFF_LEFT)
                        + value(Packet.CLIFF_FRONT_LEFT)
                        + value(Packet.CLIFF_FRONT_RIGHT)
                        + value(Packet.CLIFF_RIGHT)
                != 0;
    }

    /** Packet 14: any motor draws too much. */
    public boolean anyOvercurrent() {
        return value(Packet.OVERCURRENTS) != 0;
    }

    /** Packet 19: the distance since the last request. */
    public int distanceMm() {
        return value(Packet.DISTANCE);
    }

    /** Packet 20: the angle since the last request, counterclockwise. */
    public int angleDegrees() {
        return value(Packet.ANGLE);
    }

    /** Packet 21; empty if the robot reports a code that the specification lacks. */
    public Optional<ChargingState> chargingState() {
        return ChargingState.of(value(Packet.CHARGING_STATE));
    }

    /** Packet 34. */
    public boolean onInternalCharger() {
        return bit(Packet.CHARGING_SOURCES, 0);
    }

    /** Packet 34. */
    public boolean onHomeBase() {
        return bit(Packet.CHARGING_SOURCES, 1);
    }

    /** Packet 22. */
    public int voltageMilliVolts() {
        return value(Packet.VOLTAGE);
    }

    /** Packet 23: negative while the battery discharges. */
    public int currentMilliAmps() {
        return value(Packet.CURRENT);
    }

    /** Packet 25. */
    public int batteryChargeMilliAmpHours() {
        return value(Packet.BATTERY_CHARGE);
    }

    /** Packet 26. */
    public int batteryCapacityMilliAmpHours() {
        return value(Packet.BATTERY_CAPACITY);
    }

    /**
     * How full the battery is, 0 to 100 %, from packets 25 and 26; empty if the robot reports no capacity. An old
     * battery may report more charge than capacity, or underflow below zero.
     */
    public OptionalInt batteryPercent() {
        int capacity = batteryCapacityMilliAmpHours();
        if (capacity == 0) {
            return OptionalInt.empty();
        }
        int charge = (short) batteryChargeMilliAmpHours();
        return OptionalInt.of((int) Math.max(0, Math.min(100, Math.round(100.0 * charge / capacity))));
    }

    /** Packet 43: wraps around in 16 bits, see {@link #encoderDelta}. */
    public int leftEncoderCounts() {
        return value(Packet.LEFT_ENCODER);
    }

    /** Packet 44: wraps around in 16 bits, see {@link #encoderDelta}. */
    public int rightEncoderCounts() {
        return value(Packet.RIGHT_ENCODER);
    }

    /** Counts from one encoder reading to the next, right across the wrap as long as it is less than 32768. */
    public static int encoderDelta(int earlierCounts, int laterCounts) {
        return (short) (laterCounts - earlierCounts);
    }

    /** Packet 56. */
    public int mainBrushMilliAmps() {
        return value(Packet.MAIN_BRUSH_CURRENT);
    }

    /** Packet 57. */
    public int sideBrushMilliAmps() {
        return value(Packet.SIDE_BRUSH_CURRENT);
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof SensorValues that && present == that.present && Arrays.equals(values, that.values);
    }

    @Override
    public int hashCode() {
        return 31 * Long.hashCode(present) + Arrays.hashCode(values);
    }

    /** For messages: {@code {BUTTONS=2, OI_MODE=1}}. */
    @Override
    public String toString() {
        StringJoiner text = new StringJoiner(", ", "{", "}");
        for (Packet packet : Packet.ALL) {
            if (has(packet)) {
                text.add(packet + "=" + values[index(packet)]);
            }
        }
        return text.toString();
    }
}
