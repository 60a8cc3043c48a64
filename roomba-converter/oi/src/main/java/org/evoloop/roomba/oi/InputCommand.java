package org.evoloop.roomba.oi;

import java.util.List;

/**
 * A command that asks for sensor packets (specification, "Input Commands"). The replies to {@link Sensors} and
 * {@link QueryList} are raw bytes and would mix with the frames of a {@link Stream}, so use only one at a time.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface InputCommand extends Command {

    /** Asks for one packet or group, which comes as raw bytes, see {@link SensorValues#decode}. */
    record Sensors(PacketId packet) implements InputCommand {
        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), packet.id());
        }
    }

    /**
     * Asks for these packets every 15 ms from now on, see {@link StreamFramer}.
     *
     * @param packets in the order in which they shall come; empty ends the stream; a frame must not take more than 255
     *     bytes of ids and data. At 115200 bit/s only 172 bytes fit between two frames
     */
    record Stream(List<PacketId> packets) implements InputCommand {

        public Stream {
            packets = List.copyOf(packets);
            StreamFrame.payloadLength(packets);
        }

        @Override
        public byte[] bytes() {
            return withIds(opcode(), packets);
        }
    }

    /**
     * Asks for these packets once; they come as raw bytes, see {@link SensorValues#decode}.
     *
     * @param packets in the order in which they shall come, at most 255
     */
    record QueryList(List<PacketId> packets) implements InputCommand {

        public QueryList {
            packets = List.copyOf(packets);
            Bytes.requireRange("number of packets", packets.size(), 0, 255, "");
        }

        @Override
        public byte[] bytes() {
            return withIds(opcode(), packets);
        }
    }

    /** Pauses the stream, or resumes it with the packets last asked for. */
    record PauseResumeStream(boolean resume) implements InputCommand {
        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), resume ? 1 : 0);
        }
    }

    private static byte[] withIds(Opcode opcode, List<PacketId> packets) {
        int[] data = new int[1 + packets.size()];
        data[0] = packets.size();
        for (int i = 0; i < packets.size(); i++) {
            data[1 + i] = packets.get(i).id();
        }
        return Bytes.of(opcode, data);
    }
}
