package org.evoloop.xmi.dialect;

import java.io.IOException;
import java.io.InputStream;

/** Counts the bytes that are read from another stream. */
abstract class CountedInput extends InputStream {
    private final InputStream bytes;

    CountedInput(InputStream bytes) {
        this.bytes = bytes;
    }

    /** Takes the number of bytes that were just read. */
    abstract void count(int read);

    @Override
    public final int read() throws IOException {
        int read = bytes.read();
        count(read < 0 ? 0 : 1);
        return read;
    }

    @Override
    public final int read(byte[] buffer, int offset, int length) throws IOException {
        int read = bytes.read(buffer, offset, length);
        count(Math.max(0, read));
        return read;
    }

    @Override
    public boolean markSupported() {
        return bytes.markSupported();
    }

    @Override
    public void mark(int limit) {
        bytes.mark(limit);
    }

    @Override
    public void reset() throws IOException {
        bytes.reset();
    }

    @Override
    public void close() throws IOException {
        bytes.close();
    }
}
