package org.evoloop.engine.codec;

import java.util.List;

/** The items that {@link ByteWriter} has written. */
final class ByteItems extends Items {
    private final byte[] bytes;
    private int place;

    ByteItems(byte[] bytes, int from) {
        this.bytes = bytes;
        this.place = from;
    }

    @Override
    SnapshotException wrong(String what) {
        return new SnapshotException("snapshot, before byte " + place + ": " + what);
    }

    @Override
    SnapshotException damaged(String what) {
        return wrong(what + "; the bytes are damaged, use another copy or start without it");
    }

    private int octet() {
        if (place >= bytes.length) {
            throw damaged("they end too early");
        }
        return bytes[place++] & 0xff;
    }

    private boolean isOne() {
        int octet = octet();
        if (octet > 1) {
            throw damaged("0 or 1 was expected, not " + octet);
        }
        return octet == 1;
    }

    @Override
    void next(String name) {}

    @Override
    String next() {
        return word();
    }

    @Override
    void ends() {}

    @Override
    void endsAll() {
        if (place < bytes.length) {
            throw damaged("there is more text after the end");
        }
    }

    @Override
    boolean isNone() {
        return !isOne();
    }

    @Override
    String word() {
        int code = octet();
        if (code == WordCodes.OTHER) {
            return text();
        } else if (!WordCodes.isKnown(code)) {
            throw damaged("there is no word " + code);
        }
        return WordCodes.word(code);
    }

    @Override
    boolean choice(String yes, String no) {
        return isOne();
    }

    @Override
    int choice(List<String> words) {
        int which = octet();
        if (which >= words.size()) {
            throw damaged("one of " + words + " was expected, not " + which);
        }
        return which;
    }

    @Override
    long number() {
        long folded = unsigned();
        return (folded >>> 1) ^ -(folded & 1);
    }

    private long unsigned() {
        long number = 0;
        for (int shift = 0; shift < Long.SIZE; shift += ByteWriter.BITS) {
            int octet = octet();
            number |= (long) (octet & (ByteWriter.MORE - 1)) << shift;
            if (octet < ByteWriter.MORE) {
                return number;
            }
        }
        throw damaged("a number is too long");
    }

    @Override
    String text() {
        long header = unsigned();
        boolean wide = (header & ByteWriter.WIDE) != 0;
        long count = header >>> 1;
        if (count > (bytes.length - place) / (wide ? 2 : 1)) {
            throw damaged("a text is longer than the rest");
        }
        return wide ? wide((int) count) : narrow((int) count);
    }

    @SuppressWarnings("deprecation") // It does not decode, which is right here: the core uses no charsets.
    private String narrow(int count) {
        String text = new String(bytes, 0, place, count);
        place += count;
        return text;
    }

    private String wide(int count) {
        char[] characters = new char[count];
        for (int at = 0; at < count; at++) {
            characters[at] = (char) ((octet() << Byte.SIZE) | octet());
        }
        return new String(characters);
    }

    @Override
    Object value() {
        int type = octet();
        if (type == ByteWriter.TEXT) {
            return text();
        } else if (type == ByteWriter.TRUE || type == ByteWriter.FALSE) {
            return type == ByteWriter.TRUE;
        } else if (type != ByteWriter.NUMBER) {
            throw damaged("there is no value of type " + type);
        }
        String number = text();
        try {
            return Double.valueOf(number);
        } catch (NumberFormatException e) {
            throw damaged("'" + number + "' is not a value");
        }
    }
}
