package org.evoloop.fleet.device;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.Function;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.SnapshotBytes;
import org.evoloop.engine.codec.SnapshotException;
import org.jspecify.annotations.Nullable;

/**
 * {@link DeviceState} as a fleet stores it: the version of this format, a few numbers, then the snapshot's bytes. Stored
 * text ({@link DeviceStateText}) can be read, too.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class DeviceStateBytes {
    /** Differs from the first byte of any text. */
    private static final byte VERSION = 1;

    /** The first byte of what remains of a removed device. */
    private static final byte REMOVED = 2;

    private static final byte FIRST_OF_TEXT = 'e';
    private static final int BITS = 7;
    private static final int MORE = 1 << BITS;

    /** The greatest lengths: of a number, and of everything except the models' version and the snapshot. */
    private static final int NUMBER = 10;

    private static final int MOST = 1 + 11 * NUMBER;

    /** Enough for most snapshots, together with what the rest leaves. */
    private static final int SNAPSHOT = 64;

    private static final Order.Kind[] KINDS = {Order.Kind.SEND, Order.Kind.RUN, Order.Kind.LOCATE};

    private DeviceStateBytes() {}

    /** The bytes of {@code state}. */
    public static byte[] write(DeviceState state) {
        byte[] model = state.model().getBytes(StandardCharsets.UTF_8);
        ByteBuffer bytes = ByteBuffer.allocate(MOST + model.length + SNAPSHOT);
        bytes.put(VERSION);
        put(bytes, model.length);
        bytes.put(model);
        put(bytes, state.sequence());
        put(bytes, state.heard());
        put(bytes, state.open());
        put(bytes, state.lost());
        return SnapshotBytes.write(bytes.array(), bytes.position(), state.snapshot());
    }

    /** The bytes of what remains of a removed device. */
    public static byte[] write(Past past) {
        ByteBuffer bytes = ByteBuffer.allocate(1 + 2 * NUMBER);
        bytes.put(REMOVED);
        put(bytes, past.sequence());
        put(bytes, past.visit());
        return Arrays.copyOf(bytes.array(), bytes.position());
    }

    /** Whether {@code bytes} are those of a removed device. */
    public static boolean isRemoved(byte[] bytes) {
        return bytes.length > 0 && bytes[0] == REMOVED;
    }

    /**
     * What remains of the removed device with these bytes.
     *
     * @throws IllegalArgumentException if they are not such bytes
     */
    public static Past past(byte[] bytes) {
        if (!isRemoved(bytes)) {
            throw damaged();
        }
        ByteBuffer numbers = ByteBuffer.wrap(bytes, 1, bytes.length - 1);
        try {
            return new Past(number(numbers), number(numbers));
        } catch (BufferUnderflowException e) {
            throw damaged();
        }
    }

    private static void put(ByteBuffer bytes, Order.@Nullable Open order) {
        put(bytes, order == null ? 0 : order.sequence());
        if (order != null) {
            put(bytes, order.occurrence());
            put(bytes, code(order.kind()));
            put(bytes, order.deadlineNanos());
        }
    }

    private static int code(Order.Kind kind) {
        for (int code = 0; code < KINDS.length; code++) {
            if (KINDS[code] == kind) {
                return code;
            }
        }
        throw new IllegalStateException(kind + " has no number");
    }

    private static void put(ByteBuffer bytes, long number) {
        long rest = number;
        while ((rest & -MORE) != 0) {
            bytes.put((byte) ((rest & (MORE - 1)) | MORE));
            rest >>>= BITS;
        }
        bytes.put((byte) rest);
    }

    /**
     * The version of the models in {@code bytes}.
     *
     * @throws IllegalArgumentException if they are not such bytes, or those of another version
     */
    public static String model(byte[] bytes) {
        return isText(bytes) ? DeviceStateText.model(bytes) : model(begun(bytes));
    }

    private static boolean isText(byte[] bytes) {
        return bytes.length > 0 && bytes[0] == FIRST_OF_TEXT;
    }

    private static ByteBuffer begun(byte[] bytes) {
        if (bytes.length == 0 || bytes[0] != VERSION) {
            String found = bytes.length == 0 ? "nothing" : "version " + bytes[0];
            throw new IllegalArgumentException(
                    found + " cannot be read, only version " + VERSION + "; use the version of Evoloop that wrote it");
        }
        return ByteBuffer.wrap(bytes, 1, bytes.length - 1);
    }

    private static String model(ByteBuffer bytes) {
        try {
            long length = number(bytes);
            if (length < 0 || length > bytes.remaining()) {
                throw damaged();
            }
            byte[] model = new byte[(int) length];
            bytes.get(model);
            return new String(model, StandardCharsets.UTF_8);
        } catch (BufferUnderflowException e) {
            throw damaged();
        }
    }

    private static IllegalArgumentException damaged() {
        return new IllegalArgumentException("the bytes are damaged");
    }

    /**
     * Reads {@code bytes}.
     *
     * @param rules gives the rules of a version of models
     * @throws IllegalArgumentException if they are not such bytes
     * @throws SnapshotException if they name something that the models lack
     */
    public static DeviceState read(Function<String, Rules> rules, byte[] bytes) {
        if (isText(bytes)) {
            return DeviceStateText.read(rules.apply(DeviceStateText.model(bytes)), bytes);
        }
        ByteBuffer head = begun(bytes);
        String model = model(head);
        try {
            long sequence = number(head);
            long heard = number(head);
            Order.Open open = order(head);
            Order.Open lost = order(head);
            return new DeviceState(
                    model, sequence, heard, open, lost, SnapshotBytes.read(rules.apply(model), bytes, head.position()));
        } catch (BufferUnderflowException e) {
            throw damaged();
        }
    }

    private static Order.@Nullable Open order(ByteBuffer bytes) {
        long sequence = number(bytes);
        if (sequence == 0) {
            return null;
        }
        long occurrence = number(bytes);
        long code = number(bytes);
        if (code < 0 || code >= KINDS.length) {
            throw damaged();
        }
        return new Order.Open(sequence, occurrence, KINDS[(int) code], number(bytes));
    }

    private static long number(ByteBuffer bytes) {
        long number = 0;
        for (int shift = 0; shift < Long.SIZE; shift += BITS) {
            int octet = bytes.get() & 0xff;
            number |= (long) (octet & (MORE - 1)) << shift;
            if (octet < MORE) {
                return number;
            }
        }
        throw damaged();
    }
}
