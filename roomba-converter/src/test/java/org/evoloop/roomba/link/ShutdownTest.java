package org.evoloop.roomba.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.evoloop.roomba.simulator.Pty;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A program that ends with an open link still makes its robot safe. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class ShutdownTest {
    private static final byte[] START = {(byte) 128};
    private static final byte[] STOP = {(byte) 173};

    @Test
    void aShutdownHookOfTheLinkStillReachesTheRobot() throws Exception {
        try (Pty pty = Pty.open();
                Peer peer = Peer.listening(pty)) {
            Process program = new ProcessBuilder(
                            Path.of(System.getProperty("java.home"), "bin", "java")
                                    .toString(),
                            "-cp",
                            System.getProperty("java.class.path"),
                            Program.class.getName(),
                            pty.path().toString())
                    .inheritIO()
                    .start();
            assertThat(program.waitFor(Listener.PATIENCE_SECONDS, TimeUnit.SECONDS))
                    .isTrue();
            assertThat(peer.awaitHeard(2)).containsExactly(START[0], STOP[0]);
        }
    }

    /** Starts the robot and ends without a word. */
    static final class Program {
        private Program() {}

        public static void main(String[] arguments) {
            Link link = new SerialLink(new SerialSettings(arguments[0]));
            link.open(new Listener());
            SerialLink.addShutdownHook(new Thread(() -> {
                link.send(STOP);
                link.close();
            }));
            link.send(START);
        }
    }
}
