package org.evoloop.roomba.camera.live;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/** A network camera that sends what a test tells it to: Motion JPEG on loopback. */
final class HttpCamera implements AutoCloseable {
    private static final int BETWEEN_FRAMES_MILLIS = 20;

    private final HttpServer server;
    private final ExecutorService threads = Executors.newCachedThreadPool();
    private final LinkedBlockingQueue<byte[]> once = new LinkedBlockingQueue<>();
    private final AtomicInteger connections = new AtomicInteger();
    private volatile byte[][] repeated = {};
    private volatile boolean refusing;
    private volatile boolean closed;

    HttpCamera() throws IOException {
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext("/", this::serve);
        server.setExecutor(threads);
        server.start();
    }

    String url() {
        return "http://127.0.0.1:" + server.getAddress().getPort() + "/";
    }

    int connections() {
        return connections.get();
    }

    /** Sends it before all that is repeated. */
    void send(byte[] jpeg) {
        once.add(jpeg);
    }

    /** Sends these in turn from now on. */
    void repeat(byte[]... jpegs) {
        refusing = false;
        repeated = jpegs;
    }

    /** Stays connected and sends nothing. */
    void pause() {
        repeated = new byte[0][];
    }

    /** Hangs up, and answers nobody. */
    void refuse() {
        refusing = true;
    }

    private void serve(HttpExchange exchange) throws IOException {
        connections.incrementAndGet();
        try (exchange) {
            if (refusing) {
                exchange.sendResponseHeaders(503, -1);
                return;
            }
            exchange.getResponseHeaders().set("Content-Type", "multipart/x-mixed-replace; boundary=frame");
            exchange.sendResponseHeaders(200, 0);
            OutputStream out = exchange.getResponseBody();
            for (int turn = 0; !refusing && !closed; turn++) {
                byte[] next = once.poll(BETWEEN_FRAMES_MILLIS, TimeUnit.MILLISECONDS);
                byte[][] others = repeated;
                if (next == null && others.length > 0) {
                    next = others[turn % others.length];
                }
                if (next != null) {
                    out.write(("--frame\r\nContent-Type: image/jpeg\r\nContent-Length: " + next.length + "\r\n\r\n")
                            .getBytes(StandardCharsets.US_ASCII));
                    out.write(next);
                    out.write("\r\n".getBytes(StandardCharsets.US_ASCII));
                    out.flush();
                }
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        closed = true;
        server.stop(0);
        threads.shutdownNow();
    }
}
