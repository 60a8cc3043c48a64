package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.Logged;
import org.evoloop.time.Threads;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Mosquitto behind a door that lets no client of MQTT 5 in, as a broker from before 2018 does. */
class OldBrokerTest {
    private static final Duration LIMIT = Duration.ofSeconds(60);
    private static final byte NEWEST = 4;

    /** MQTT 3.1.1's "unacceptable protocol version". */
    private static final byte[] REFUSAL = {0x20, 2, 0, 1};

    @TempDir
    private Path directory;

    private final Logged logged = new Logged("org.evoloop.mqtt");
    private final List<Socket> sockets = new CopyOnWriteArrayList<>();
    private final AtomicInteger refused = new AtomicInteger();

    @AfterEach
    void endLog() {
        logged.close();
    }

    private ServerSocket door(Mosquitto broker, boolean answers) throws IOException {
        ServerSocket door = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        Threads.start("door", () -> {
            try {
                while (true) {
                    Socket client = door.accept();
                    sockets.add(client);
                    Threads.start("door-client", () -> admit(client, broker, answers));
                }
            } catch (IOException closed) {
                // The test is over.
            }
        });
        return door;
    }

    private void admit(Socket client, Mosquitto broker, boolean answers) {
        try (client) {
            // A CONNECT: type, length, 0 4 M Q T T, version.
            byte[] start = new byte[9];
            DataInputStream in = new DataInputStream(client.getInputStream());
            in.readFully(start);
            byte version = (start[1] & 0x80) == 0 ? start[8] : in.readByte();
            if (version > NEWEST) {
                refused.incrementAndGet();
                if (answers) {
                    client.getOutputStream().write(REFUSAL);
                }
                return;
            }
            try (Socket inside = new Socket(InetAddress.getLoopbackAddress(), broker.port())) {
                sockets.add(inside);
                inside.getOutputStream().write(start);
                Threads.start("door-back", () -> pass(inside, client));
                in.transferTo(inside.getOutputStream());
            }
        } catch (IOException gone) {
            // One of them has left.
        }
    }

    private static void pass(Socket from, Socket to) {
        try (from;
                to) {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            in.transferTo(out);
        } catch (IOException gone) {
            // One of them has left.
        }
    }

    private void closeAll() throws IOException {
        for (Socket socket : sockets) {
            socket.close();
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aBrokerThatOnlyKnowsMqtt311IsSpokenToInIt(boolean answers) throws Exception {
        try (Mosquitto broker = new Mosquitto(directory).start();
                ServerSocket door = door(broker, answers);
                Watcher watcher = new Watcher(broker)) {
            List<Message> heard = new CopyOnWriteArrayList<>();
            watcher.publish("lamp/own", "kept", true);
            try (BrokerConnection connection =
                    new BrokerConnection(BrokerAddress.parse("mqtt://127.0.0.1:" + door.getLocalPort()), "test")) {
                connection.will(Message.state("lamp/here", "offline"));
                connection.publish(Message.state("lamp/here", "online"));
                connection.subscribe("lamp/own", heard::add);
                connection.open();
                watcher.awaitNewest("lamp/here", "online");
                watcher.publish("lamp/own", "live", false);
                await().atMost(LIMIT)
                        .until(() -> heard.equals(
                                List.of(Message.state("lamp/own", "kept"), Message.command("lamp/own", "live"))));
                closeAll();
                watcher.awaitHeard("lamp/here", "offline");
                watcher.awaitNewest("lamp/here", "online");
            }
            watcher.awaitNewest("lamp/here", "offline");
            assertThat(refused).hasValueGreaterThanOrEqualTo(2);
        }
    }

    @Test
    void aLoginThatItRefusesIsSaid() throws Exception {
        Path passwords = Files.createFile(directory.resolve("passwords"));
        try (Mosquitto broker = new Mosquitto(directory)
                        .with("user root", "allow_anonymous false", "password_file " + passwords)
                        .start();
                ServerSocket door = door(broker, true);
                BrokerConnection connection = new BrokerConnection(
                        BrokerAddress.parse("mqtt://ha@127.0.0.1:" + door.getLocalPort())
                                .withPassword("wr0ng"),
                        "test")) {
            connection.open();
            await().atMost(LIMIT).until(() -> !logged.lines().isEmpty());
            assertThat(logged.lines().get(0))
                    .contains("refuses the login of user ha")
                    .doesNotContain("wr0ng");
        }
    }
}
