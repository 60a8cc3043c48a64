package org.evoloop.device;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/** A device at a TCP port that answers lines. */
final class LineDevice implements AutoCloseable {
    private final ServerSocket server;
    private final List<String> heard = new CopyOnWriteArrayList<>();
    private final UnaryOperator<String> answers;
    private volatile @Nullable OutputStream out;

    /** @param answers an empty text for no answer */
    LineDevice(UnaryOperator<String> answers) throws IOException {
        this.server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        this.answers = answers;
        Thread thread = new Thread(this::serve, "line-device");
        thread.setDaemon(true);
        thread.start();
    }

    private void serve() {
        while (!server.isClosed()) {
            try (Socket socket = server.accept();
                    BufferedReader in = new BufferedReader(
                            new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
                out = socket.getOutputStream();
                for (String line = in.readLine(); line != null; line = in.readLine()) {
                    heard.add(line);
                    String answer = answers.apply(line);
                    if (!answer.isEmpty()) {
                        tell(answer);
                    }
                }
            } catch (IOException closed) {
                out = null;
            }
        }
    }

    void tell(String line) throws IOException {
        OutputStream to = out;
        if (to == null) {
            throw new IOException("nobody is connected");
        }
        to.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        to.flush();
    }

    boolean isConnected() {
        return out != null;
    }

    List<String> heard() {
        return heard;
    }

    String address() {
        return "tcp://127.0.0.1:" + server.getLocalPort();
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
