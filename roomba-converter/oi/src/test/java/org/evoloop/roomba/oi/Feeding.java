package org.evoloop.roomba.oi;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Shared by the tests of both parsers: feeding whole arrays, joining arrays, seeded noise. */
final class Feeding {
    private Feeding() {}

    static List<CommandParser.Parsed> parse(byte[] bytes) {
        List<CommandParser.Parsed> parsed = new ArrayList<>();
        new CommandParser(parsed::add).feed(bytes, 0, bytes.length);
        return parsed;
    }

    static byte[] octets(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }

    static byte[] join(byte[]... parts) {
        int length = 0;
        for (byte[] part : parts) {
            length += part.length;
        }
        byte[] all = new byte[length];
        int offset = 0;
        for (byte[] part : parts) {
            System.arraycopy(part, 0, all, offset, part.length);
            offset += part.length;
        }
        return all;
    }

    static byte[] noise(Random random, int length) {
        byte[] bytes = new byte[length];
        random.nextBytes(bytes);
        return bytes;
    }
}
