package org.evoloop.roomba.simulator.robot;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFramer;

/** A simulated robot under test, with everything that it has sent. */
final class Bench {
    static final Command START = new Command.Start();
    static final Command SAFE = new Command.Safe();
    static final Command FULL = new Command.Full();

    private final ByteArrayOutputStream sent = new ByteArrayOutputStream();
    final SimulatedRoomba robot;

    Bench(RobotOptions options) {
        robot = new SimulatedRoomba(options, sent::writeBytes);
    }

    Bench() {
        this(RobotOptions.defaults());
    }

    /** A robot in this mode; awake in Safe and Full, else in standby. */
    static Bench in(OiMode mode) {
        return in(mode, RobotOptions.defaults());
    }

    /** A robot in this mode; awake in Safe and Full, else in standby. */
    static Bench in(OiMode mode, RobotOptions options) {
        Bench bench = new Bench(options);
        switch (mode) {
            case OFF -> {}
            case PASSIVE -> bench.send(START);
            case SAFE -> bench.send(START, SAFE);
            case FULL -> bench.send(START, FULL);
        }
        return bench;
    }

    Bench send(Command... commands) {
        for (Command command : commands) {
            robot.receive(command.bytes(), command.bytes().length);
        }
        return this;
    }

    Bench ticks(long count) {
        for (long i = 0; i < count; i++) {
            robot.tick();
        }
        return this;
    }

    Bench seconds(double seconds) {
        return ticks(Math.round(seconds * 1000 / SimulatedRoomba.TICK_MILLIS));
    }

    RobotState state() {
        return robot.state();
    }

    /** The bytes that the robot has sent since the last call. */
    byte[] sent() {
        byte[] bytes = sent.toByteArray();
        sent.reset();
        return bytes;
    }

    /** What the robot has sent since the last call, as text. */
    String sentText() {
        return new String(sent(), StandardCharsets.ISO_8859_1);
    }

    /** Pulls the wake line low for this long. */
    Bench pulse(int millis) {
        robot.wakeLine(true);
        ticks((millis + SimulatedRoomba.TICK_MILLIS - 1) / SimulatedRoomba.TICK_MILLIS);
        robot.wakeLine(false);
        return this;
    }

    /** The frames in what the robot has sent since the last call. */
    List<SensorValues> frames() {
        byte[] bytes = sent();
        return StreamFramer.forAnyPackets().feed(bytes, 0, bytes.length);
    }

    /** Asks for one packet. */
    int query(Packet packet) {
        sent();
        send(new InputCommand.Sensors(packet));
        return SensorValues.decode(List.of(packet), sent()).value(packet);
    }

    Bench stream(PacketId... packets) {
        return send(new InputCommand.Stream(List.of(packets)));
    }
}
