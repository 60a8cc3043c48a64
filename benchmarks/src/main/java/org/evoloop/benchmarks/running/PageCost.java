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
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.console.Console;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.time.Threads;

/**
 * How much a listener and the viewers of the live page delay a conversion. The same events without either, with a
 * listener that only counts, and with {@value #VIEWERS} viewers who read and {@value #SLOW} who never do, alternating in
 * one process, so that other load on the computer affects all. Events come with pauses, then as fast as possible.
 */
public final class PageCost {
    private static final int VIEWERS = 5;
    private static final int SLOW = 2;
    private static final int EVENTS = 500;
    private static final int FAST_EVENTS = 5_000;

    /** Far more often than anybody presses a button, and long enough to send each event to the viewers. */
    private static final long PAUSE_NANOS = 2_000_000;

    private final CleaningRobot robot;
    private final PathTimer timer;
    private final int events;
    private final long pauseNanos;
    private final Histogram without = Latencies.histogram();
    private final Histogram heard = Latencies.histogram();
    private final Histogram watched = Latencies.histogram();
    private long missed;

    private PageCost(CleaningRobot robot, PathTimer timer, int events, long pauseNanos) {
        this.robot = robot;
        this.timer = timer;
        this.events = events;
        this.pauseNanos = pauseNanos;
    }

    /**
     * Prints medians and 99th percentiles in microseconds, and how many events the listener has missed.
     *
     * @param arguments the number of turns of each kind
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        int turns = Integer.parseInt(arguments[0]);
        PathTimer timer = new PathTimer();
        try (CleaningRobot robot = new CleaningRobot(timer, true)) {
            new PageCost(robot, timer, EVENTS, PAUSE_NANOS).measure("", turns);
            new PageCost(robot, timer, FAST_EVENTS, 0).measure("FAST ", turns);
            robot.requireAllHandled();
        }
    }

    private void measure(String prefix, int turns) throws IOException, InterruptedException {
        new PageCost(robot, timer, events, pauseNanos).turns(1); // a warm-up
        turns(turns);
        Latencies.print(prefix + "NONE", without);
        Latencies.print(prefix + "LISTENER", heard);
        Latencies.print(prefix + "VIEWERS", watched);
        System.out.println(prefix + "LISTENER missed " + missed);
    }

    private void turns(int turns) throws IOException, InterruptedException {
        for (int turn = 0; turn < turns; turn++) {
            turn(without);
            heard();
            watched();
        }
    }

    private void turn(Histogram nanos) throws InterruptedException {
        timer.clear();
        for (int event = 0; event < events; event++) {
            robot.next();
            if (pauseNanos > 0) {
                LockSupport.parkNanos(pauseNanos);
            }
        }
        nanos.add(timer.nanos());
    }

    private void heard() throws InterruptedException {
        CountDownLatch ends = new CountDownLatch(events);
        ConverterListener listener = new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                ends.countDown();
            }
        };
        robot.converter().addListener(listener);
        turn(heard);
        // The last notices may still be on their way.
        if (!ends.await(1, TimeUnit.SECONDS)) {
            missed += ends.getCount();
        }
        robot.converter().removeListener(listener);
    }

    /** The viewers hang up first; then the page is closed. */
    private void watched() throws IOException, InterruptedException {
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
            turn(watched);
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
