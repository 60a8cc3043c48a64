package org.evoloop.roomba.simulator.robot;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFrame;
import org.evoloop.roomba.oi.StreamFrame.Checksum;

/** Answers queries at once, and sends the stream's frame at every tick. */
final class Reporter {
    private final ToIntFunction<Packet> sensors;
    private final Checksum checksum;
    private final Consumer<byte[]> sink;
    private List<PacketId> stream = List.of();
    private boolean paused;

    Reporter(ToIntFunction<Packet> sensors, Checksum checksum, Consumer<byte[]> sink) {
        this.sensors = sensors;
        this.checksum = checksum;
        this.sink = sink;
    }

    void execute(InputCommand command) {
        if (command instanceof InputCommand.Sensors query) {
            sink.accept(SensorValues.encode(List.of(query.packet()), sensors));
        } else if (command instanceof InputCommand.QueryList query) {
            sink.accept(SensorValues.encode(query.packets(), sensors));
        } else if (command instanceof InputCommand.Stream request) {
            stream = request.packets();
            paused = false;
        } else if (command instanceof InputCommand.PauseResumeStream request) {
            paused = !request.resume();
        }
    }

    void tick() {
        if (isStreaming()) {
            sink.accept(StreamFrame.encode(stream, sensors, checksum));
        }
    }

    void endStream() {
        stream = List.of();
    }

    boolean isStreaming() {
        return !stream.isEmpty() && !paused;
    }

    /** The number of packets in the stream, paused or not. */
    int streamPackets() {
        return stream.size();
    }
}
