package org.evoloop.serial;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import org.evoloop.line.LineTransport.Wire;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;

/** An open serial port with its input and output streams. */
final class SerialWire implements Wire {
    private final Link link;

    private final InputStream input = new InputStream() {
        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
        }

        @Override
        public int read(byte[] bytes, int start, int length) throws IOException {
            byte[] taken = new byte[length];
            int count = link.receive(taken);
            LinkException loss = link.loss();
            if (count < 0 && loss != null) {
                throw new IOException(loss.getMessage(), loss);
            }
            System.arraycopy(taken, 0, bytes, start, Math.max(count, 0));
            return count;
        }
    };

    private final OutputStream output = new OutputStream() {
        @Override
        public void write(int value) throws IOException {
            write(new byte[] {(byte) value}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int start, int length) throws IOException {
            try {
                link.send(Arrays.copyOfRange(bytes, start, start + length));
            } catch (LinkException failure) {
                throw new IOException(failure.getMessage(), failure);
            }
        }
    };

    SerialWire(Link link) {
        this.link = link;
    }

    @Override
    public InputStream input() {
        return input;
    }

    @Override
    public OutputStream output() {
        return output;
    }

    @Override
    public void close() {
        link.close();
    }
}
