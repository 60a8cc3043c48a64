package org.evoloop.device;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import org.evoloop.imitation.Imitation;
import org.evoloop.time.Threads;

/**
 * A daemon that speaks as lircd(8) describes, section "Socket command interface": {@code SEND_ONCE REMOTE KEY} is answered as
 * soon as it was sent, whether or not the device has seen it.
 */
final class LircImitation implements AutoCloseable {
    private final ServerSocketChannel server;
    private final Map<String, String> keys;
    private final Imitation device;

    /** @param keys the device's events, by the names of keys */
    LircImitation(Path socket, Map<String, String> keys, Imitation device) throws IOException {
        this.keys = keys;
        this.device = device;
        server = ServerSocketChannel.open(StandardProtocolFamily.UNIX).bind(UnixDomainSocketAddress.of(socket));
        Threads.start("lirc", this::serve);
    }

    private void serve() {
        while (server.isOpen()) {
            try (SocketChannel client = server.accept();
                    BufferedReader in = new BufferedReader(
                            new InputStreamReader(Channels.newInputStream(client), StandardCharsets.UTF_8))) {
                for (String line = in.readLine(); line != null; line = in.readLine()) {
                    client.write(ByteBuffer.wrap(answer(line).getBytes(StandardCharsets.UTF_8)));
                }
            } catch (IOException gone) {
                // The client, or the server.
            }
        }
    }

    private String answer(String line) {
        String[] words = line.split(" ");
        String event = words.length == 3 && words[0].equals("SEND_ONCE") ? keys.get(words[2]) : null;
        if (event == null) {
            return "BEGIN\n" + line + "\nERROR\nDATA\n1\nunknown command\nEND\n";
        }
        device.take(event);
        return "BEGIN\n" + line + "\nSUCCESS\nEND\n";
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
