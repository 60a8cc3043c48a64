package org.evoloop.benchmarks.running;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.evoloop.roomba.simulator.eye.CameraImage;
import org.evoloop.roomba.simulator.eye.Eye;
import org.evoloop.roomba.simulator.eye.EyeOptions;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.RandomRooms;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.webcam.Jpeg;

/**
 * A program that acts as a camera and, like one, costs almost no processor time. It draws its pictures in advance, and
 * sends them to one client at a time, repeatedly, as Motion JPEG at 30 frames/s. They show a robot driving to its
 * marker in a furnished room.
 */
final class CameraPlayer {
    private static final int PICTURES = 60;
    private static final double FIRST_MM = 2_000;
    private static final double LAST_MM = 600;
    private static final long ROOM_SEED = 1;
    private static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(1) / 30;

    private CameraPlayer() {}

    /** Prints its address when it is ready, and runs until its standard input ends. */
    public static void main(String[] arguments) throws IOException {
        List<byte[]> pictures = pictures();
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Thread serving = new Thread(() -> serve(server, pictures), "player");
            serving.setDaemon(true);
            serving.start();
            System.out.println(
                    "http://" + server.getInetAddress().getHostAddress() + ":" + server.getLocalPort() + "/");
            System.in.transferTo(OutputStream.nullOutputStream());
        }
    }

    private static List<byte[]> pictures() {
        Room room = RandomRooms.withMarker(ROOM_SEED);
        Marker marker = room.marker().orElseThrow();
        Eye eye = new Eye(EyeOptions.defaults());
        List<byte[]> pictures = new ArrayList<>();
        try (Jpeg jpeg = new Jpeg()) {
            for (int number = 0; number < PICTURES; number++) {
                double distanceMm = FIRST_MM + (LAST_MM - FIRST_MM) * number / (PICTURES - 1);
                CameraImage seen = eye.render(room, marker.before(distanceMm), 0, number);
                pictures.add(jpeg.encode(seen));
            }
        }
        return pictures;
    }

    private static void serve(ServerSocket server, List<byte[]> pictures) {
        while (!server.isClosed()) {
            try (Socket client = server.accept()) {
                client.setTcpNoDelay(true);
                send(client.getOutputStream(), pictures);
            } catch (IOException hungUp) {
                // Serve the next client.
            }
        }
    }

    /** Sends pictures until the client hangs up. The request is ignored, since there is only one resource. */
    private static void send(OutputStream client, List<byte[]> pictures) throws IOException {
        client.write(ascii("HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=picture\r\n\r\n"));
        long next = System.nanoTime();
        for (int number = 0; ; number = (number + 1) % pictures.size()) {
            byte[] picture = pictures.get(number);
            client.write(
                    ascii("--picture\r\nContent-Type: image/jpeg\r\nContent-Length: " + picture.length + "\r\n\r\n"));
            client.write(picture);
            client.write(ascii("\r\n"));
            next += PERIOD_NANOS;
            for (long wait = next - System.nanoTime(); wait > 0; wait = next - System.nanoTime()) {
                LockSupport.parkNanos(wait);
            }
        }
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
