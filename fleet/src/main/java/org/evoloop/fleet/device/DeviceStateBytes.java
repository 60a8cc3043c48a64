package org.evoloop.fleet.device;

import java.util.List;
import java.util.function.Function;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.ByteItems;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.engine.codec.CodecException;
import org.evoloop.engine.codec.SnapshotBytes;
import org.jspecify.annotations.Nullable;

/**
 * {@link DeviceState} as a fleet stores it: the version of this format, the models' version, a few numbers, then the snapshot's
 * bytes.
 *
 * <p>Errors: bytes that are damaged, or name something that the models lack, are a {@link CodecException}.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class DeviceStateBytes {
    /** The version of this format. */
    private static final int VERSION = 3;

    /** The first byte of what remains of a removed device, in this version of the format. */
    private static final int REMOVED = 4;

    /** Their places are in the bytes. */
    private static final List<Order.Kind> KINDS = List.of(Order.Kind.SEND, Order.Kind.RUN, Order.Kind.LOCATE);

    private DeviceStateBytes() {}

    /** The bytes of {@code state}. */
    public static byte[] write(DeviceState state) {
        ByteWriter bytes = new ByteWriter();
        bytes.octet(VERSION).text(state.model()).number(state.sequence()).number(state.heard());
        write(bytes, state.open());
        write(bytes, state.lost());
        SnapshotBytes.write(bytes, state.snapshot());
        return bytes.written();
    }

    private static void write(ByteWriter bytes, Order.@Nullable Open order) {
        bytes.truth(order != null);
        if (order != null) {
            bytes.number(order.sequence())
                    .number(order.occurrence())
                    .number(KINDS.indexOf(order.kind()))
                    .number(order.deadlineNanos());
        }
    }

    /** The bytes of what remains of a removed device. */
    public static byte[] write(Past past) {
        ByteWriter bytes = new ByteWriter();
        bytes.octet(REMOVED).number(past.sequence()).number(past.visit());
        return bytes.written();
    }

    /** Whether {@code bytes} are those of a removed device. */
    public static boolean isRemoved(byte[] bytes) {
        return bytes.length > 0 && bytes[0] == REMOVED;
    }

    /** What remains of the removed device with these bytes. */
    public static Past past(byte[] bytes) {
        ByteItems items = begun(bytes, REMOVED);
        return new Past(items.number(), items.number());
    }

    private static ByteItems begun(byte[] bytes, int version) {
        ByteItems items = new ByteItems("state", bytes, 0);
        items.requireVersion(items.octet(), version);
        return items;
    }

    /** The version of the models in {@code bytes}. */
    public static String model(byte[] bytes) {
        return begun(bytes, VERSION).text();
    }

    /**
     * Reads {@code bytes}.
     *
     * @param rules gives the rules of a version of models
     */
    public static DeviceState read(Function<String, Rules> rules, byte[] bytes) {
        ByteItems items = begun(bytes, VERSION);
        String model = items.text();
        long sequence = items.number();
        long heard = items.number();
        Order.Open open = order(items);
        Order.Open lost = order(items);
        return new DeviceState(model, sequence, heard, open, lost, SnapshotBytes.read(rules.apply(model), items));
    }

    private static Order.@Nullable Open order(ByteItems items) {
        return items.truth()
                ? new Order.Open(items.number(), items.number(), items.oneOf(KINDS), items.number())
                : null;
    }
}
