package org.evoloop.device;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import org.evoloop.mqtt.Certificate;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.time.Threads;

/**
 * The broker in a Roomba: TLS with a certificate that nobody has signed, MQTT 3.1.1 and nothing newer, and a login. Behind it
 * is a Mosquitto.
 */
final class RobotBroker implements AutoCloseable {
    static final String PASSWORD = ":1:1512345678:s3cr3tOfTheRobot";
    private static final byte NEWEST = 4;

    private final Mosquitto inside;
    private final ServerSocket door;
    private final String fingerprint;
    private final List<Socket> sockets = new CopyOnWriteArrayList<>();

    /** @param home the broker at which the robot is imitated: what is said there is said here, and the other way around */
    RobotBroker(Path folder, Mosquitto home) throws Exception {
        Certificate own = Certificate.of(folder, "robot", "dns:roomba");
        KeyStore keys = KeyStore.getInstance("PKCS12");
        try (InputStream in = Files.newInputStream(own.store())) {
            keys.load(in, Certificate.PASSWORD.toCharArray());
        }
        fingerprint = HexFormat.of()
                .formatHex(MessageDigest.getInstance("SHA-256")
                        .digest(keys.getCertificate("a").getEncoded()));
        KeyManagerFactory managers = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        managers.init(keys, Certificate.PASSWORD.toCharArray());
        SSLContext tls = SSLContext.getInstance("TLS");
        tls.init(managers.getKeyManagers(), null, null);
        inside = new Mosquitto(folder)
                .with(
                        "user root",
                        "allow_anonymous false",
                        "password_file " + passwords(folder),
                        "connection home",
                        "address 127.0.0.1:" + home.port(),
                        "topic # both",
                        "topic $aws/# both")
                .start();
        door = tls.getServerSocketFactory().createServerSocket(0, 50, InetAddress.getLoopbackAddress());
        Threads.start("robot-door", this::open);
    }

    private static Path passwords(Path folder) throws Exception {
        Path file = Files.createFile(folder.resolve("robot-passwords"));
        Process made = new ProcessBuilder(
                        Mosquitto.program("mosquitto_passwd"), "-b", file.toString(), "BLID", PASSWORD)
                .inheritIO()
                .start();
        if (made.waitFor() != 0) {
            throw new AssertionError("mosquitto_passwd has failed");
        }
        return file;
    }

    private void open() {
        while (!door.isClosed()) {
            try {
                Socket client = door.accept();
                sockets.add(client);
                Threads.start("robot-client", () -> admit(client));
            } catch (IOException closed) {
                // The test is over.
            }
        }
    }

    /** A client that speaks a newer MQTT is shown out. */
    private void admit(Socket client) {
        try (client) {
            // A CONNECT: type, length of one or two bytes, 0 4 M Q T T, version.
            byte[] start = new byte[9];
            DataInputStream in = new DataInputStream(client.getInputStream());
            in.readFully(start);
            byte more = (start[1] & 0x80) == 0 ? 0 : in.readByte();
            byte version = (start[1] & 0x80) == 0 ? start[8] : more;
            if (version > NEWEST) {
                return;
            }
            try (Socket broker = new Socket(InetAddress.getLoopbackAddress(), inside.port())) {
                sockets.add(broker);
                broker.getOutputStream().write(start);
                if ((start[1] & 0x80) != 0) {
                    broker.getOutputStream().write(more);
                }
                Threads.start("robot-back", () -> pass(broker, client));
                in.transferTo(broker.getOutputStream());
            }
        } catch (IOException gone) {
            // One of them has left.
        }
    }

    private static void pass(Socket from, Socket to) {
        try (from;
                to) {
            from.getInputStream().transferTo(to.getOutputStream());
        } catch (IOException gone) {
            // One of them has left.
        }
    }

    int port() {
        return door.getLocalPort();
    }

    String fingerprint() {
        return fingerprint;
    }

    @Override
    public void close() throws IOException {
        door.close();
        for (Socket socket : sockets) {
            socket.close();
        }
        inside.close();
    }
}
