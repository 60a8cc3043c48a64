package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.evoloop.natives.Pty;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A program that ends with an open link still leaves its device safe. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class ShutdownTest {
    private static final byte[] START = {(byte) 128};
    private static final byte[] STOP = {(byte) 173};

    @Test
    void aProgramThatEndsStillReachesTheDevice() throws Exception {
        try (Pty pty = Pty.open();
                Peer peer = Peer.listening(pty)) {
            Process program = start(pty, "end");
            assertEnds(program);
            assertThat(peer.awaitHeard(2)).containsExactly(START[0], STOP[0]);
        }
    }

    @Test
    void soDoesAProgramWhoseTerminalIsClosed() throws Exception {
        assumeFalse(hangupsAreIgnored(), "the build itself runs under nohup");
        try (Pty pty = Pty.open();
                Peer peer = Peer.listening(pty)) {
            Process program = start(pty, "wait");
            peer.awaitHeard(1);
            assertEnds(new ProcessBuilder("sh", "-c", "kill -HUP " + program.pid()).start());
            assertEnds(program);
            assertThat(peer.awaitHeard(2)).containsExactly(START[0], STOP[0]);
        }
    }

    private static Process start(Pty pty, String afterStart) throws IOException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classPath = System.getProperty("java.class.path");
        String port = pty.path().toString();
        return new ProcessBuilder(
                        java,
                        "--enable-native-access=ALL-UNNAMED",
                        "-XX:+UseSerialGC",
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        classPath,
                        Program.class.getName(),
                        port,
                        afterStart)
                .inheritIO()
                .start();
    }

    private static void assertEnds(Process process) throws InterruptedException {
        boolean ended = process.waitFor(Listener.PATIENCE_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).isTrue();
    }

    /** Child processes inherit ignored signals. */
    private static boolean hangupsAreIgnored() throws IOException {
        long build = ProcessHandle.current().parent().orElseThrow().pid();
        try (Stream<String> status = Files.lines(Path.of("/proc/" + build + "/status"))) {
            String ignored = status.filter(line -> line.startsWith("SigIgn:"))
                    .findFirst()
                    .orElseThrow()
                    .substring("SigIgn:".length())
                    .strip();
            return (Long.parseUnsignedLong(ignored, 16) & 1) != 0;
        }
    }

    /** Starts the device, then exits or waits to be killed, printing nothing. */
    static final class Program {
        private Program() {}

        public static void main(String[] arguments) throws InterruptedException {
            Link link = new Listener().listenTo(SerialLink.open(new SerialSettings(arguments[0])));
            SerialLink.addShutdownHook(new Thread(() -> {
                link.send(STOP);
                link.close();
            }));
            link.send(START);
            if (arguments[1].equals("wait")) {
                new CountDownLatch(1).await();
            }
        }
    }
}
