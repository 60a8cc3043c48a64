package org.evoloop.benchmarks.file;

import com.sun.management.ThreadMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.LongStream;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.report.TemporaryFolder;
import org.evoloop.config.Options;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.DeviceConverter;
import org.evoloop.device.DeviceFile;
import org.evoloop.evolution.ModelPair;
import org.evoloop.line.LineConnection;
import org.evoloop.line.LineExecute;
import org.evoloop.line.LineMonitor;
import org.evoloop.line.LineTransport;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;

/**
 * An event of a controller, from the line that reports it to the line that is sent for it, through a device file and through
 * the same in Java. The device is a socket of this process.
 */
final class FileWiring {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int TURN = 20;
    private static final long PAUSE_NANOS = 1_000_000;
    private static final Duration LIMIT = Duration.ofSeconds(10);

    private static final String MODELS = """
            ```mermaid
            ---
            title: original
            ---
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
            ```

            ```mermaid
            ---
            title: new
            ---
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
            ```
            """;

    private static final String FILE = """
            converter: fan
            models: {original: models.md#original, new: models.md#new}
            connections: {fan: {lines: "tcp://127.0.0.1:PORT"}}
            device:
              send: {power: PWR}
              answer: {ok: OK, error: ERR.*, within: 10 s}
              state: {is Off: "Off", is On: "On"}
            controller: {press: {remote on: power, remote power: power}}
            """;

    private FileWiring() {}

    /** A device that is operated by its own remote control. */
    private static final class Fan implements AutoCloseable {
        private final ServerSocket server;
        private final Histogram nanos = Latencies.histogram();
        private Socket socket = new Socket();
        private long bytes;
        private long presses;

        Fan() throws IOException {
            server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        }

        int port() {
            return server.getLocalPort();
        }

        void connect() throws IOException {
            socket = server.accept();
            socket.setTcpNoDelay(true);
        }

        void press(int times, boolean counted) throws IOException {
            BufferedReader in =
                    new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
            Writer out = new OutputStreamWriter(socket.getOutputStream(), StandardCharsets.UTF_8);
            long before = othersBytes();
            for (int press = 0; press < times; press++) {
                LockSupport.parkNanos(PAUSE_NANOS);
                long begun = System.nanoTime();
                out.write("remote power\n");
                out.flush();
                if (!"PWR".equals(in.readLine())) {
                    throw new IOException("the converter sent something else");
                }
                if (counted) {
                    nanos.recordValue(System.nanoTime() - begun);
                }
                out.write("OK\n");
                out.flush();
            }
            // Until what follows the last press is done.
            LockSupport.parkNanos(PAUSE_NANOS);
            if (counted) {
                bytes += othersBytes() - before;
                presses += times;
            }
        }

        /** What all threads but this one have allocated. */
        private static long othersBytes() {
            long self = Thread.currentThread().getId();
            return LongStream.of(THREADS.getAllThreadIds())
                    .filter(id -> id != self)
                    .map(THREADS::getThreadAllocatedBytes)
                    .filter(some -> some > 0)
                    .sum();
        }

        void print(String name) {
            Latencies.print(name, nanos);
            System.out.println(name + " bytes " + (presses == 0 ? 0 : bytes / (double) presses));
        }

        @Override
        public void close() throws IOException {
            socket.close();
            server.close();
        }
    }

    /**
     * Prints the results.
     *
     * @param arguments how many presses are measured in each of the two
     */
    public static void main(String[] arguments) throws Exception {
        int presses = Integer.parseInt(arguments[0]);
        try (TemporaryFolder folder = TemporaryFolder.create();
                SystemClock clock = new SystemClock();
                SystemClock other = new SystemClock();
                Fan first = new Fan();
                Fan second = new Fan();
                DeviceConverter file = byFile(folder.path(), first.port(), clock);
                SystemEventConverter java = new SystemEventConverter(LoopConfig.defaults("java", other));
                LineConnection line =
                        inJava(java, second.port(), file.converter().knowledge().models(), other)) {
            line.open();
            first.connect();
            second.connect();
            for (int done = 0; done < 2 * presses; done += TURN) {
                // The first half warms up.
                first.press(TURN, done >= presses);
                second.press(TURN, done >= presses);
            }
            first.print("file");
            second.print("java");
        }
    }

    private static DeviceConverter byFile(Path folder, int port, SystemClock clock) throws IOException {
        Files.writeString(folder.resolve("models.md"), MODELS);
        Path path = Files.writeString(folder.resolve("fan.yaml"), FILE.replace("PORT", Integer.toString(port)));
        DeviceFile file = DeviceFile.read(path, Options.of());
        return DeviceConverter.open(
                file, file.models(), clock, new PushMonitor("Console"), new EventAnalyze(), nothing());
    }

    private static EventExecute nothing() {
        return EventExecute.of("Nothing", Set.of(), step -> {});
    }

    private static LineConnection inJava(
            SystemEventConverter converter, int port, ModelPair models, SystemClock clock) {
        LineConnection line = new LineConnection(LineTransport.tcp("127.0.0.1", port), clock);
        converter.addMonitor(new PushMonitor("Console"));
        converter.addMonitor(new LineMonitor("fan", line)
                .found(Map.of("is Off", "Off", "is On", "On"))
                .controller(Map.of("remote on", "power", "remote power", "power")));
        converter.addExecute(
                new LineExecute("fanExecute", line, Map.of("power", "PWR")).answeredBy("OK", "ERR.*", LIMIT));
        converter.addLink(line);
        converter.addExecute(nothing());
        converter.addKnowledge(new StateKnowledge(models));
        converter.build();
        converter.start();
        return line;
    }
}
