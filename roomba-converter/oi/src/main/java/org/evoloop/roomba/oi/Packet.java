package org.evoloop.roomba.oi;

import java.util.List;

/**
 * One sensor value of the robot (specification, "Input Commands" and "Roomba Open Interface Sensors Quick Reference").
 * The range is the documented one; robots have been seen to leave it, so decoding never enforces it.
 *
 * @since 0.1
 */
public enum Packet implements PacketId {
    /** Bits: 0 bump right, 1 bump left, 2 wheel drop right, 3 wheel drop left. */
    BUMPS_AND_WHEEL_DROPS(7, Form.UNSIGNED_8, "", 0, 15),
    /** 1 while the sensor on its right sees a wall. */
    WALL(8, Form.UNSIGNED_8, "", 0, 1),
    /** 1 while there is no floor under the left sensor. */
    CLIFF_LEFT(9, Form.UNSIGNED_8, "", 0, 1),
    /** 1 while there is no floor under the front left sensor. */
    CLIFF_FRONT_LEFT(10, Form.UNSIGNED_8, "", 0, 1),
    /** 1 while there is no floor under the front right sensor. */
    CLIFF_FRONT_RIGHT(11, Form.UNSIGNED_8, "", 0, 1),
    /** 1 while there is no floor under the right sensor. */
    CLIFF_RIGHT(12, Form.UNSIGNED_8, "", 0, 1),
    /** 1 while the beam of a virtual wall is seen. */
    VIRTUAL_WALL(13, Form.UNSIGNED_8, "", 0, 1),
    /** Bits: 0 side brush, 2 main brush, 3 right wheel, 4 left wheel. */
    OVERCURRENTS(14, Form.UNSIGNED_8, "", 0, 29),
    /** The amount of dirt picked up. */
    DIRT_DETECT(15, Form.UNSIGNED_8, "", 0, 255),
    /** Always 0. */
    UNUSED_16(16, Form.UNSIGNED_8, "", 0, 255),
    /** 0 none, 129 to 143 the remote control, 160 to 173 the dock, 162 a virtual wall. */
    INFRARED_OMNI(17, Form.UNSIGNED_8, "", 0, 255),
    /** Bits of {@link Button}; set only while a button is held down. */
    BUTTONS(18, Form.UNSIGNED_8, "", 0, 255),
    /** The distance since the last request; saturates. Wrong before firmware 3.3.0. */
    DISTANCE(19, Form.SIGNED_16, "mm", -32768, 32767),
    /** The angle since the last request, counterclockwise; saturates. Wrong up to firmware 3.4.0. */
    ANGLE(20, Form.SIGNED_16, "degrees", -32768, 32767),
    /** The code of a {@link ChargingState}. */
    CHARGING_STATE(21, Form.UNSIGNED_8, "", 0, 5),
    /** Of the battery. */
    VOLTAGE(22, Form.UNSIGNED_16, "mV", 0, 65535),
    /** Negative while the battery discharges. */
    CURRENT(23, Form.SIGNED_16, "mA", -32768, 32767),
    /** Of the battery. */
    TEMPERATURE(24, Form.SIGNED_8, "degrees Celsius", -128, 127),
    /** Has been seen to underflow to about 65000. */
    BATTERY_CHARGE(25, Form.UNSIGNED_16, "mAh", 0, 65535),
    /** The charge of a full battery, as estimated by the robot. */
    BATTERY_CAPACITY(26, Form.UNSIGNED_16, "mAh", 0, 65535),
    /** How strong the wall is seen. */
    WALL_SIGNAL(27, Form.UNSIGNED_16, "", 0, 1023),
    /** How strong the left sensor sees the floor. */
    CLIFF_LEFT_SIGNAL(28, Form.UNSIGNED_16, "", 0, 4095),
    /** How strong the front left sensor sees the floor. */
    CLIFF_FRONT_LEFT_SIGNAL(29, Form.UNSIGNED_16, "", 0, 4095),
    /** How strong the front right sensor sees the floor. */
    CLIFF_FRONT_RIGHT_SIGNAL(30, Form.UNSIGNED_16, "", 0, 4095),
    /** How strong the right sensor sees the floor. */
    CLIFF_RIGHT_SIGNAL(31, Form.UNSIGNED_16, "", 0, 4095),
    /** Always 0. */
    UNUSED_32(32, Form.UNSIGNED_8, "", 0, 255),
    /** Always 0. */
    UNUSED_33(33, Form.UNSIGNED_16, "", 0, 65535),
    /** Bits: 0 internal charger, 1 home base. */
    CHARGING_SOURCES(34, Form.UNSIGNED_8, "", 0, 3),
    /** The code of an {@link OiMode}; some 600 robots report one more than that. */
    OI_MODE(35, Form.UNSIGNED_8, "", 0, 3),
    /** The song that was chosen last. */
    SONG_NUMBER(36, Form.UNSIGNED_8, "", 0, 4),
    /** 1 while a song plays. */
    SONG_PLAYING(37, Form.UNSIGNED_8, "", 0, 1),
    /** The number of packets in a frame of the stream. */
    NUMBER_OF_STREAM_PACKETS(38, Form.UNSIGNED_8, "", 0, 108),
    /** Of the last {@link ActuatorCommand.Drive}, not measured. */
    REQUESTED_VELOCITY(39, Form.SIGNED_16, "mm/s", -500, 500),
    /** Of the last {@link ActuatorCommand.Drive}. Wrong before firmware 3.3.0. */
    REQUESTED_RADIUS(40, Form.SIGNED_16, "mm", -32768, 32767),
    /** Of the last {@link ActuatorCommand.DriveDirect}, not measured. */
    REQUESTED_RIGHT_VELOCITY(41, Form.SIGNED_16, "mm/s", -500, 500),
    /** Of the last {@link ActuatorCommand.DriveDirect}, not measured. */
    REQUESTED_LEFT_VELOCITY(42, Form.SIGNED_16, "mm/s", -500, 500),
    /** Wraps around in 16 bits. */
    LEFT_ENCODER(43, Form.SIGNED_16, "counts", -32768, 32767),
    /** Wraps around in 16 bits. */
    RIGHT_ENCODER(44, Form.SIGNED_16, "counts", -32768, 32767),
    /** Bits: 0 left, 1 front left, 2 centre left, 3 centre right, 4 front right, 5 right. */
    LIGHT_BUMPER(45, Form.UNSIGNED_8, "", 0, 127),
    /** How near something is to the left of the bumper. */
    LIGHT_BUMP_LEFT_SIGNAL(46, Form.UNSIGNED_16, "", 0, 4095),
    /** How near something is to the front left of the bumper. */
    LIGHT_BUMP_FRONT_LEFT_SIGNAL(47, Form.UNSIGNED_16, "", 0, 4095),
    /** How near something is to the middle of the bumper, left. */
    LIGHT_BUMP_CENTER_LEFT_SIGNAL(48, Form.UNSIGNED_16, "", 0, 4095),
    /** How near something is to the middle of the bumper, right. */
    LIGHT_BUMP_CENTER_RIGHT_SIGNAL(49, Form.UNSIGNED_16, "", 0, 4095),
    /** How near something is to the front right of the bumper. */
    LIGHT_BUMP_FRONT_RIGHT_SIGNAL(50, Form.UNSIGNED_16, "", 0, 4095),
    /** How near something is to the right of the bumper. */
    LIGHT_BUMP_RIGHT_SIGNAL(51, Form.UNSIGNED_16, "", 0, 4095),
    /** The code received on the left; values as of {@link #INFRARED_OMNI}. */
    INFRARED_LEFT(52, Form.UNSIGNED_8, "", 0, 255),
    /** The code received on the right; values as of {@link #INFRARED_OMNI}. */
    INFRARED_RIGHT(53, Form.UNSIGNED_8, "", 0, 255),
    /** Of the left wheel. */
    LEFT_MOTOR_CURRENT(54, Form.SIGNED_16, "mA", -32768, 32767),
    /** Of the right wheel. */
    RIGHT_MOTOR_CURRENT(55, Form.SIGNED_16, "mA", -32768, 32767),
    /** Of the main brush. */
    MAIN_BRUSH_CURRENT(56, Form.SIGNED_16, "mA", -32768, 32767),
    /** Of the side brush. */
    SIDE_BRUSH_CURRENT(57, Form.SIGNED_16, "mA", -32768, 32767),
    /** Bits: 0 the front wheel shows forward progress, 1 its sensor is off or dirty. */
    STASIS(58, Form.UNSIGNED_8, "", 0, 3);

    private enum Form {
        UNSIGNED_8(1, 0, 255),
        SIGNED_8(1, Byte.MIN_VALUE, Byte.MAX_VALUE),
        UNSIGNED_16(2, 0, 65535),
        SIGNED_16(2, Short.MIN_VALUE, Short.MAX_VALUE);

        private final int size;
        private final int lowest;
        private final int highest;

        Form(int size, int lowest, int highest) {
            this.size = size;
            this.lowest = lowest;
            this.highest = highest;
        }
    }

    static final int FIRST_ID = 7;
    static final int LAST_ID = 58;
    static final List<Packet> ALL = List.of(values());

    private final int id;
    private final Form form;
    private final String unit;
    private final int min;
    private final int max;

    Packet(int id, Form form, String unit, int min, int max) {
        this.id = id;
        this.form = form;
        this.unit = unit;
        this.min = min;
        this.max = max;
    }

    static Packet at(int id) {
        return ALL.get(id - FIRST_ID);
    }

    @Override
    public int id() {
        return id;
    }

    @Override
    public int size() {
        return form.size;
    }

    @Override
    public List<Packet> members() {
        return List.of(this);
    }

    /** Whether the bytes are a two's complement number. */
    public boolean isSigned() {
        return form.lowest < 0;
    }

    /** The unit of the value; empty if it has none. */
    public String unit() {
        return unit;
    }

    /** The smallest value that the specification names. */
    public int min() {
        return min;
    }

    /** The largest value that the specification names. */
    public int max() {
        return max;
    }

    int decode(byte[] bytes, int offset) {
        return switch (form) {
            case UNSIGNED_8 -> Bytes.unsigned8(bytes, offset);
            case SIGNED_8 -> bytes[offset];
            case UNSIGNED_16 -> Bytes.unsigned16(bytes, offset);
            case SIGNED_16 -> Bytes.signed16(bytes, offset);
        };
    }

    /** Writes {@link #size()} bytes; the value need not be in the documented range, but must fit into them. */
    void encode(int value, byte[] target, int offset) {
        Bytes.requireRange("packet " + id + " (" + name() + ")", value, form.lowest, form.highest, unit);
        if (form.size == 2) {
            target[offset] = (byte) Bytes.high(value);
        }
        target[offset + form.size - 1] = (byte) value;
    }
}
