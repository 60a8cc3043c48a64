package org.evoloop.http;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.SSLSocketFactory;

/**
 * Sends requests and waits for their answers. Each request has a new connection, so that none is sent on a connection
 * that the device is just closing.
 *
 * <p>Threading: thread-safe.
 */
final class Caller {
    private static final int ATTEMPTS = 3;
    private static final int REDIRECTED = 300;
    private static final int WRONG = 400;

    private final Duration limit;

    Caller(Duration limit) {
        if (limit.isNegative() || limit.isZero()) {
            throw new IllegalArgumentException("no device answers within " + limit + "; give more than 0");
        }
        this.limit = limit;
    }

    /** Extracts a value from an answer. */
    interface Use<T> {
        T of(ReceivedReply reply) throws IOException;
    }

    /**
     * Sends a request.
     *
     * @throws UnansweredException if there is no answer, or the part that is used is incomplete
     * @throws IOException if the device cannot be reached, or answers with a status that the call does not accept
     */
    <T> T call(HttpCall call, Use<T> use) throws IOException, InterruptedException {
        for (int attempt = 1; ; attempt++) {
            try {
                return once(call, use);
            } catch (UnansweredException unanswered) {
                if (!call.repeatable() || attempt == ATTEMPTS) {
                    throw unanswered;
                }
            }
        }
    }

    /**
     * Connects to the device, without asking it for anything.
     *
     * @throws IOException if it cannot be reached
     */
    void reach(HttpCall call) throws IOException, InterruptedException {
        try (SocketChannel channel = SocketChannel.open()) {
            connected(channel, call, new Limit(limit)).close();
        }
    }

    private <T> T once(HttpCall call, Use<T> use) throws IOException, InterruptedException {
        Limit left = new Limit(limit);
        try (SocketChannel channel = SocketChannel.open();
                Socket socket = connected(channel, call, left)) {
            ReceivedReply reply;
            try {
                socket.getOutputStream().write(call.bytes());
                socket.getOutputStream().flush();
                reply = ReceivedReply.read(left.of(socket));
                if (call.accepts(reply.status())) {
                    return use.of(reply);
                }
            } catch (IOException failure) {
                requireNoInterrupt();
                throw new UnansweredException(
                        call + " was not answered within " + limit.toMillis()
                                + " ms, or not to the end; whether it has arrived is not known",
                        failure);
            }
            boolean elsewhere = reply.status() >= REDIRECTED && reply.status() < WRONG;
            throw new IOException(call + " was answered with status " + reply.status()
                    + (elsewhere ? "; use the address that it redirects to" : ""));
        }
    }

    /** Connects a channel's socket, which an interrupt closes during any blocking call. */
    @SuppressWarnings("AddressSelection") // the first address of a host name is good enough
    private static Socket connected(SocketChannel channel, HttpCall call, Limit left)
            throws IOException, InterruptedException {
        String host = call.address().getHost();
        try {
            InetSocketAddress address = new InetSocketAddress(host.replaceAll("[\\[\\]]", ""), call.port());
            if (address.isUnresolved()) {
                throw new IOException("there is no host " + host);
            }
            Socket socket = channel.socket();
            socket.connect(address, left.millis());
            if (!call.isSecure()) {
                return socket;
            }
            socket.setSoTimeout(left.millis());
            SSLSocket secure = (SSLSocket)
                    ((SSLSocketFactory) SSLSocketFactory.getDefault()).createSocket(socket, host, call.port(), true);
            SSLParameters parameters = secure.getSSLParameters();
            parameters.setEndpointIdentificationAlgorithm("HTTPS");
            secure.setSSLParameters(parameters);
            secure.startHandshake();
            return secure;
        } catch (IOException failure) {
            requireNoInterrupt();
            throw new IOException(
                    call + " cannot be sent: the device cannot be reached (" + failure.getMessage()
                            + "); check that it is switched on, and the address",
                    failure);
        }
    }

    private static void requireNoInterrupt() throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
    }
}
