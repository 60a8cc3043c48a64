package org.evoloop.line;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;

/** A TCP server. */
record TcpTransport(String host, int port) implements LineTransport {
    private static final int CONNECT_MILLIS = 3_000;
    private static final int HIGHEST_PORT = 65_535;

    TcpTransport {
        if (host.isBlank() || port < 1 || port > HIGHEST_PORT) {
            throw new IllegalArgumentException("'" + host + "' port " + port
                    + " is not an address; give a host and a port from 1 to " + HIGHEST_PORT);
        }
    }

    private record TcpWire(Socket socket, InputStream input, OutputStream output) implements Wire {
        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    @Override
    @SuppressWarnings("resource") // the wire closes it
    public Wire open() throws IOException {
        InetSocketAddress address = new InetSocketAddress(host, port);
        if (address.isUnresolved()) {
            throw new IOException(this + ": there is no host " + host + "; check the name and the network");
        }
        Socket socket = new Socket();
        try {
            socket.connect(address, CONNECT_MILLIS);
            socket.setTcpNoDelay(true);
            socket.setKeepAlive(true);
            return new TcpWire(socket, socket.getInputStream(), socket.getOutputStream());
        } catch (IOException failure) {
            socket.close();
            throw explained(failure);
        }
    }

    private IOException explained(IOException failure) {
        if (failure instanceof SocketTimeoutException) {
            return new IOException(this + " does not answer; check that it is switched on and on the network", failure);
        }
        if (failure instanceof ConnectException) {
            return new IOException(this + " refuses connections; check the port, and that the server runs", failure);
        }
        return new IOException(this + " cannot be reached (" + failure.getMessage() + ")", failure);
    }

    @Override
    public String toString() {
        return host + ":" + port;
    }
}
