package org.evoloop.roomba.oi;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Finds the frames of a stream among arbitrary bytes: boot text, charging lines, noise, frames cut short. The header is
 * no proof of a frame, since 19 occurs in data too; so a frame must fit from end to end, in header, length, ids and
 * checksum. As soon as a byte does not fit, the search continues one byte after the start of the candidate, so no byte
 * that could begin a frame is skipped.
 *
 * <p>Guarantee: an intact frame is delivered if no other bytes that make up a whole valid frame overlap it from before.
 * A framer made for {@link #StreamFramer(Collection) given packets} delivers it with its last byte. One
 * {@link #forAnyPackets for any packets} may take a wrong length byte before it for that of a longer frame, and then
 * delivers it at most 252 bytes later.
 *
 * <p>One wrong byte in a frame of given packets is always noticed. Of frames spoilt in other ways about one in 256 is
 * delivered with wrong values, since the checksum has eight bits.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class StreamFramer {
    private static final int LENGTH_AT = 1;
    private static final int PAYLOAD_AT = 2;

    private final @Nullable List<PacketId> expected;
    private final int expectedPayload;

    /** The candidate from its header on, followed by bytes not examined yet. */
    private final byte[] buffer = new byte[StreamFrame.LONGEST_PAYLOAD + StreamFrame.OVERHEAD];

    private int buffered;

    /** The number of the candidate's bytes that fit so far. */
    private int fitting;

    private int sum;
    private int checksumAt;
    private int nextIdAt;
    private int idsSeen;

    private long frames;
    private long badChecksums;
    private long headerlessChecksums;
    private long skippedBytes;

    private StreamFramer(@Nullable List<PacketId> expected, int expectedPayload) {
        this.expected = expected;
        this.expectedPayload = expectedPayload;
    }

    /**
     * A framer for the requested list of packets; frames of any other stream are skipped.
     *
     * @throws IllegalArgumentException if the packets do not fit into a frame
     */
    public StreamFramer(Collection<? extends PacketId> packets) {
        this(List.copyOf(packets), StreamFrame.payloadLength(packets));
    }

    /** A framer for a stream requested by others: frames of any known packets, but at least one. */
    public static StreamFramer forAnyPackets() {
        return new StreamFramer(null, 0);
    }

    /** Handles {@code count} bytes from {@code offset} on; returns the frames that they complete, in order. */
    public List<SensorValues> feed(byte[] bytes, int offset, int count) {
        List<SensorValues> complete = new ArrayList<>(1);
        for (int i = offset; i < offset + count; i++) {
            feed(bytes[i], complete);
        }
        return complete;
    }

    private void feed(byte octet, List<SensorValues> complete) {
        buffer[buffered++] = octet;
        while (fitting < buffered) {
            if (!fits(Bytes.unsigned8(buffer, fitting))) {
                skippedBytes++;
                drop(1);
            } else if (fitting++ == checksumAt) {
                complete.add(SensorValues.decodePayload(buffer, PAYLOAD_AT, checksumAt));
                frames++;
                drop(fitting);
            }
        }
    }

    /** Whether this byte can be the candidate's next one, at {@link #fitting}. */
    private boolean fits(int octet) {
        if (fitting == 0) {
            sum = octet;
            checksumAt = Integer.MAX_VALUE;
            nextIdAt = PAYLOAD_AT;
            idsSeen = 0;
            return octet == StreamFrame.HEADER;
        }
        sum += octet;
        if (fitting == LENGTH_AT) {
            checksumAt = PAYLOAD_AT + octet;
            return expected == null ? octet > 0 : octet == expectedPayload;
        }
        if (fitting == checksumAt) {
            boolean right = (sum & 0xFF) == 0;
            badChecksums += right ? 0 : 1;
            headerlessChecksums += (sum & 0xFF) == StreamFrame.HEADER ? 1 : 0;
            return right;
        }
        return fitting < nextIdAt || fitsAsId(octet);
    }

    private boolean fitsAsId(int octet) {
        PacketId packet = expected == null ? PacketId.of(octet).orElse(null) : expected.get(idsSeen++);
        if (packet == null || packet.id() != octet) {
            return false;
        }
        nextIdAt = fitting + 1 + packet.size();
        return nextIdAt <= checksumAt;
    }

    private void drop(int count) {
        buffered -= count;
        System.arraycopy(buffer, count, buffer, 0, buffered);
        fitting = 0;
    }

    /** Frames delivered so far. */
    public long frames() {
        return frames;
    }

    /** Candidates so far that were frames in everything but the checksum. */
    public long badChecksums() {
        return badChecksums;
    }

    /** Those of them whose checksum would be right without the header, as the Roomba 500's specification has it. */
    public long headerlessChecksums() {
        return headerlessChecksums;
    }

    /** Bytes so far that belonged to no delivered frame; those of an unfinished candidate are not counted yet. */
    public long skippedBytes() {
        return skippedBytes;
    }
}
