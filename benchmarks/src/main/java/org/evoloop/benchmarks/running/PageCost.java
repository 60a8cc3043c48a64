package org.evoloop.benchmarks.running;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.console.Console;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.time.Threads;

/**
 * How much viewers of the live page delay a conversion. The same events without a page, and with {@value #VIEWERS}
 * viewers who read and {@value #SLOW} who never do, alternating in one process, so that other load on the computer
 * affects both.
 */
public final class PageCost {
    private static final int VIEWERS = 5;
    private static final int SLOW = 2;
    private static final int EVENTS = 500;

    /** Far more often than anybody presses a button, and long enough to send each event to the viewers. */
    private static final long PAUSE_NANOS = 2_000_000;

    private PageCost() {}

    /**
     * Prints medians and 99th percentiles in microseconds, without and with viewers.
     *
     * @param arguments the number of turns of each kind
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        int turns = Integer.parseInt(arguments[0]);
        Histogram without = Latencies.histogram();
        Histogram with = Latencies.histogram();
        PathTimer timer = new PathTimer();
        try (CleaningRobot robot = new CleaningRobot(timer, true)) {
            // Warm-up, not counted.
            turn(robot, timer, Latencies.histogram());
            watched(robot, timer, Latencies.histogram());
            for (int turn = 0; turn < turns; turn++) {
                turn(robot, timer, without);
                watched(robot, timer, with);
            }
            robot.requireAllHandled();
        }
        Latencies.print("NONE", without);
        Latencies.print("VIEWERS", with);
    }

    private static void turn(CleaningRobot robot, PathTimer timer, Histogram nanos) throws InterruptedException {
        timer.clear();
        for (int event = 0; event < EVENTS; event++) {
            robot.next();
            LockSupport.parkNanos(PAUSE_NANOS);
        }
        nanos.add(timer.nanos());
    }

    /** The viewers hang up first; then the page is closed. */
    private static void watched(CleaningRobot robot, PathTimer timer, Histogram nanos)
            throws IOException, InterruptedException {
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        Console console = new Console(robot.converter(), InputStream.nullInputStream(), System.out, System.err);
        List<Socket> viewers = new ArrayList<>();
        Page page = Page.open(PageOptions.at("0"), console, new PrintStream(said, true, StandardCharsets.UTF_8));
        try {
            int port = URI.create(said.toString(StandardCharsets.UTF_8).replaceFirst("(?s)page: (\\S+) .*", "$1"))
                    .getPort();
            for (int viewer = 0; viewer < VIEWERS + SLOW; viewer++) {
                viewers.add(look(port, viewer < VIEWERS));
            }
            turn(robot, timer, nanos);
        } finally {
            for (Socket viewer : viewers) {
                viewer.close();
            }
            page.close();
        }
    }

    /** Opens a viewer; returns when the answer begins. */
    private static Socket look(int port, boolean reads) throws IOException {
        Socket viewer = new Socket(InetAddress.getLoopbackAddress(), port);
        viewer.getOutputStream()
                .write(("GET /events HTTP/1.1\r\nHost: 127.0.0.1:" + port + "\r\n\r\n")
                        .getBytes(StandardCharsets.US_ASCII));
        if (viewer.getInputStream().read() != 'H') {
            throw new IOException("the page has not answered");
        }
        if (reads) {
            Threads.start("viewer", () -> {
                try {
                    viewer.getInputStream().transferTo(PrintStream.nullOutputStream());
                } catch (IOException hungUp) {
                    // Every viewer hangs up in the end.
                }
            });
        }
        return viewer;
    }
}
