package org.evoloop.roomba.oi;

import java.util.Collection;
import java.util.function.ToIntFunction;

/**
 * The robot's side of a stream (specification, "Stream"): {@code [19][n][id][data]...[id][data][checksum]}, where n
 * counts the bytes between itself and the checksum. {@link StreamFramer} is the other side.
 *
 * <p>Threading: pure functions.
 *
 * @since 0.1
 */
public final class StreamFrame {
    /** The first byte of a frame. It may also occur in the data. */
    public static final int HEADER = 19;

    /** The bytes of a frame besides ids and data: header, length and checksum. */
    static final int OVERHEAD = 3;

    static final int LONGEST_PAYLOAD = 255;

    /** The two forms of the checksum in iRobot's documents. */
    public enum Checksum {
        /** All bytes from the header to the checksum add up to 0 in 8 bits. Real robots send this form. */
        WITH_HEADER,
        /**
         * As before, but without the header. The form in the Roomba 500's specification; no robot was seen to use it.
         */
        WITHOUT_HEADER
    }

    private StreamFrame() {}

    /** The bytes of a frame with these packets, 3 to 258. */
    public static int length(Collection<? extends PacketId> packets) {
        return payloadLength(packets) + OVERHEAD;
    }

    /** The frame's length byte: one byte per id, and the data. */
    static int payloadLength(Collection<? extends PacketId> packets) {
        int length = packets.size() + PacketId.size(packets);
        Bytes.requireRange("ids and data in a stream frame", length, 0, LONGEST_PAYLOAD, "bytes");
        return length;
    }

    /** The frame that real robots send. */
    public static byte[] encode(Collection<? extends PacketId> packets, ToIntFunction<Packet> source) {
        return encode(packets, source, Checksum.WITH_HEADER);
    }

    /**
     * One frame.
     *
     * @param source asked once for each packet, in their order; a {@link SensorValues} is one by {@code values::value}
     * @throws IllegalArgumentException if a value does not fit into its packet's bytes, or the packets into a frame
     */
    public static byte[] encode(
            Collection<? extends PacketId> packets, ToIntFunction<Packet> source, Checksum checksum) {
        byte[] frame = new byte[length(packets)];
        frame[0] = HEADER;
        frame[1] = (byte) payloadLength(packets);
        int offset = 2;
        for (PacketId packet : packets) {
            frame[offset] = (byte) packet.id();
            offset = SensorValues.encode(packet, source, frame, offset + 1);
        }
        int sum = checksum == Checksum.WITH_HEADER ? HEADER : 0;
        for (int i = 1; i < offset; i++) {
            sum += frame[i];
        }
        frame[offset] = (byte) -sum;
        return frame;
    }
}
