package org.evoloop.line;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;

/** A Unix-domain socket of this machine. */
record UnixTransport(Path socket) implements LineTransport {

    /** The JDK's streams of a channel cannot read and write at the same time. */
    private record UnixWire(SocketChannel channel, InputStream input, OutputStream output) implements Wire {
        static UnixWire of(SocketChannel channel) {
            InputStream input = new InputStream() {
                @Override
                public int read() throws IOException {
                    byte[] one = new byte[1];
                    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
                }

                @Override
                public int read(byte[] bytes, int start, int length) throws IOException {
                    return channel.read(ByteBuffer.wrap(bytes, start, length));
                }
            };
            OutputStream output = new OutputStream() {
                @Override
                public void write(int one) throws IOException {
                    write(new byte[] {(byte) one}, 0, 1);
                }

                @Override
                public void write(byte[] bytes, int start, int length) throws IOException {
                    ByteBuffer rest = ByteBuffer.wrap(bytes, start, length);
                    while (rest.hasRemaining()) {
                        channel.write(rest);
                    }
                }
            };
            return new UnixWire(channel, input, output);
        }

        @Override
        public void close() throws IOException {
            channel.close();
        }
    }

    @Override
    @SuppressWarnings("resource") // the wire closes it
    public Wire open() throws IOException {
        SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX);
        try {
            channel.connect(UnixDomainSocketAddress.of(socket));
            return UnixWire.of(channel);
        } catch (IOException | RuntimeException failure) {
            channel.close();
            throw new IOException(
                    this + " cannot be reached (" + failure.getMessage()
                            + "); check that its program runs, and that this user may use the socket",
                    failure);
        }
    }

    @Override
    public String toString() {
        return "the socket " + socket;
    }
}
