package org.evoloop.roomba.oi;

import java.util.Arrays;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * The robot's side of the commands: bytes in, commands out, at each command's last byte. An unfinished command waits
 * for its bytes for ever, as the specification says. No byte can make it throw or stall.
 *
 * <p>Threading: not thread-safe; the consumer is called from {@code feed} and must not call back.
 *
 * @since 0.1
 */
public final class CommandParser {
    /** The removed Digital Outputs of Create 1: its data byte 7 must not be taken for a {@link Command.Reset}. */
    private static final int DIGITAL_OUTPUTS = 147;

    private static final int LONGEST_DATA = 2 + 2 * 255;

    /** The result of parsing bytes. */
    public sealed interface Parsed {
        /** A command, valid in every field. */
        record Accepted(Command command) implements Parsed {}

        /**
         * A complete command with a value out of its range; its bytes are consumed.
         *
         * @param nearest of the commands to the wheels, the valid one that comes nearest; what robots do is not
         *     documented, but clients rely on it
         */
        record Malformed(
                Opcode opcode, String reason, @Nullable Command nearest) implements Parsed {}

        /** A byte in the place of an opcode that is not a known opcode. */
        record UnknownOpcode(int opcode) implements Parsed {}
    }

    private final Consumer<Parsed> consumer;
    private final byte[] data = new byte[LONGEST_DATA];
    private @Nullable Opcode opcode;
    private int received;
    private boolean skipNext;

    /** Reports each command, and unrecognised bytes, on the thread that feeds it. */
    public CommandParser(Consumer<Parsed> consumer) {
        this.consumer = consumer;
    }

    /** Parses {@code count} bytes from {@code offset} on. */
    public void feed(byte[] bytes, int offset, int count) {
        for (int i = offset; i < offset + count; i++) {
            feed(bytes[i]);
        }
    }

    /** Parses one byte. */
    public void feed(byte octet) {
        Opcode current = opcode;
        if (skipNext) {
            skipNext = false;
        } else if (current == null) {
            begin(octet & 0xFF);
        } else {
            data[received++] = octet;
            finishIfComplete(current);
        }
    }

    private void begin(int code) {
        Opcode begun = Opcode.of(code).orElse(null);
        if (begun == null) {
            skipNext = code == DIGITAL_OUTPUTS;
            consumer.accept(new Parsed.UnknownOpcode(code));
        } else {
            opcode = begun;
            received = 0;
            finishIfComplete(begun);
        }
    }

    private void finishIfComplete(Opcode current) {
        if (received < current.headBytes() || received < current.headBytes() + itemBytes(current)) {
            return;
        }
        opcode = null;
        consumer.accept(parse(current, Arrays.copyOf(data, received)));
    }

    private int itemBytes(Opcode current) {
        return current.itemBytes() == 0 ? 0 : current.itemBytes() * Bytes.unsigned8(data, current.headBytes() - 1);
    }

    private static Parsed parse(Opcode opcode, byte[] data) {
        try {
            return new Parsed.Accepted(CommandDecoder.decode(opcode, data));
        } catch (IllegalArgumentException outOfRange) {
            return new Parsed.Malformed(
                    opcode, String.valueOf(outOfRange.getMessage()), CommandDecoder.nearest(opcode, data));
        }
    }
}
