package org.evoloop.natives;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.jna.Memory;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@EnabledOnOs(OS.LINUX)
@Timeout(20)
class PtyTest {
    private static final byte[] EVERY_BYTE = everyByte();

    @TempDir
    Path folder;

    @Test
    void everyByteValueTravelsUnchangedBothWays() throws IOException {
        try (Pty pty = Pty.open();
                RandomAccessFile client = client(pty)) {
            client.write(EVERY_BYTE);
            assertThat(readExactly(pty, EVERY_BYTE.length)).isEqualTo(EVERY_BYTE);

            assertThat(pty.write(EVERY_BYTE, EVERY_BYTE.length)).isEqualTo(EVERY_BYTE.length);
            byte[] arrived = new byte[EVERY_BYTE.length];
            client.readFully(arrived);
            assertThat(arrived).isEqualTo(EVERY_BYTE);
        }
    }

    @Test
    void theLineStaysRawForTheNextClient() throws IOException {
        try (Pty pty = Pty.open()) {
            client(pty).close();
            try (RandomAccessFile client = client(pty)) {
                client.write(EVERY_BYTE);
                assertThat(readExactly(pty, EVERY_BYTE.length)).isEqualTo(EVERY_BYTE);
            }
        }
    }

    @Test
    void aClientIsPresentExactlyWhileItHasThePortOpen() throws IOException {
        try (Pty pty = Pty.open()) {
            assertThat(pty.clientPresent()).isFalse();
            assertThat(pty.read(new byte[1], 200)).isEqualTo(Pty.NO_CLIENT);
            try (RandomAccessFile client = client(pty)) {
                assertThat(pty.clientPresent()).isTrue();
                assertThat(pty.read(new byte[1], 0)).isZero();
                client.write(7);
            }
            assertThat(pty.clientPresent()).isFalse();
            assertThat(pty.read(new byte[1], 0))
                    .as("what the client wrote before it closed")
                    .isEqualTo(1);
            assertThat(pty.read(new byte[1], 0)).isEqualTo(Pty.NO_CLIENT);
        }
    }

    @Test
    void readingWithoutAClientRests() throws IOException {
        try (Pty pty = Pty.open()) {
            long cpuBefore = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
            long start = System.nanoTime();
            for (int i = 0; i < 20; i++) {
                assertThat(pty.read(new byte[1], 200)).isEqualTo(Pty.NO_CLIENT);
            }
            long cpu = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - cpuBefore;
            assertThat(cpu).isLessThan((System.nanoTime() - start) / 2);
        }
    }

    @Test
    void aFullBufferDropsAndCountsInsteadOfBlocking() throws IOException {
        try (Pty pty = Pty.open()) {
            byte[] much = new byte[100_000];
            assertThat(pty.write(much, much.length)).as("without a client").isZero();
            assertThat(pty.droppedBytes()).isZero();
            try (RandomAccessFile client = client(pty)) {
                int taken = pty.write(much, much.length);
                assertThat(taken).isBetween(4_000, much.length - 1);
                assertThat(pty.droppedBytes()).isEqualTo(much.length - taken);
                client.readFully(new byte[taken]);
                assertThat(pty.write(much, 100)).isEqualTo(100);
            }
        }
    }

    @Test
    void theClientsBaudRateIsSeen() throws IOException {
        try (Pty pty = Pty.open();
                RandomAccessFile client = client(pty)) {
            assertThat(client.getFD().valid()).isTrue();
            setBaudAsAClientDoes(pty.slavePath(), 19_200, 0xE);
            assertThat(pty.clientBaud()).isEqualTo(19_200);
            setBaudAsAClientDoes(pty.slavePath(), 115_200, 0x1002);
            assertThat(pty.clientBaud()).isEqualTo(115_200);
        }
    }

    @Test
    void hangUpEndsAWaitingReadAndTheClientsSession() throws Exception {
        try (Pty pty = Pty.open();
                RandomAccessFile client = client(pty)) {
            CompletableFuture<Integer> waiting = CompletableFuture.supplyAsync(() -> {
                int result = 0;
                while (result == 0) {
                    result = pty.read(new byte[1], 200);
                }
                return result;
            });
            pty.hangUp();
            assertThat(waiting.get(20, TimeUnit.SECONDS)).isEqualTo(Pty.NO_CLIENT);
            assertThatThrownBy(() -> client.write(1)).isInstanceOf(IOException.class);
            assertThat(pty.write(new byte[1], 1)).isZero();
            assertThat(pty.clientBaud()).isZero();
            assertThat(pty.clientPresent()).isFalse();
            pty.hangUp();
        }
    }

    @Test
    void theSymlinkFollowsTheCable() throws IOException {
        Path link = folder.resolve("device");
        try (Pty first = Pty.open(link)) {
            assertThat(first.path()).isEqualTo(link);
            assertThat(Files.readSymbolicLink(link)).isEqualTo(first.slavePath());
            Files.delete(link);
            try (Pty second = Pty.open(link)) {
                assertThat(Files.readSymbolicLink(link)).isEqualTo(second.slavePath());
                first.hangUp();
                assertThat(Files.readSymbolicLink(link))
                        .as("the first does not remove the second's link")
                        .isEqualTo(second.slavePath());
            }
            assertThat(Files.exists(link, LinkOption.NOFOLLOW_LINKS)).isFalse();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFileInTheSymlinksPlaceIsNotTouched() throws IOException {
        Path precious = Files.writeString(folder.resolve("device"), "precious");
        assertThatThrownBy(() -> Pty.open(precious))
                .isInstanceOf(IOException.class)
                .hasMessage(precious + " exists and is not a symbolic link; remove it or choose another path");
        assertThat(precious).hasContent("precious");
    }

    @ParameterizedTest
    @ValueSource(strings = {"precious", "missing", "/dev/null", "/dev/ttyUSB0", "/dev/pts", "/dev/pts/../null"})
    void aSymlinkToAnythingElseIsNotReplaced(String target) throws IOException {
        Files.writeString(folder.resolve("precious"), "precious");
        Path link = Files.createSymbolicLink(folder.resolve("device"), Path.of(target));
        assertThatThrownBy(() -> Pty.open(link))
                .isInstanceOf(IOException.class)
                .hasMessage(link + " is a symbolic link to " + target
                        + ", which no simulator made; remove it or choose another path");
        assertThat(Files.readSymbolicLink(link)).isEqualTo(Path.of(target));
        Files.delete(link);
    }

    @Test
    void aLinkLeftBehindIsReplacedAndNothingBesideItIs() throws IOException {
        Path neighbour = Files.writeString(folder.resolve("device.new"), "precious");
        Path link = Files.createSymbolicLink(folder.resolve("device"), Path.of("/dev/pts/99999"));
        try (Pty pty = Pty.open(link)) {
            assertThat(Files.readSymbolicLink(link)).isEqualTo(pty.slavePath());
        }
        assertThat(neighbour).hasContent("precious");
    }

    @Test
    void aSymlinkInAMissingFolderIsRefusedAndLeaksNothing() throws IOException {
        Path nowhere = folder.resolve("missing").resolve("device");
        long before = ptyDescriptors();
        assertThatThrownBy(() -> Pty.open(nowhere))
                .isInstanceOf(IOException.class)
                .hasMessage("cannot make the symbolic link " + nowhere + "; its folder must exist and be writable");
        assertThat(ptyDescriptors()).isEqualTo(before);
    }

    private static long ptyDescriptors() throws IOException {
        try (var descriptors = Files.list(Path.of("/proc/self/fd"))) {
            return descriptors
                    .filter(descriptor -> target(descriptor).contains("ptmx"))
                    .count();
        }
    }

    private static String target(Path descriptor) {
        try {
            return Files.readSymbolicLink(descriptor).toString();
        } catch (IOException gone) {
            return "";
        }
    }

    private static RandomAccessFile client(Pty pty) throws IOException {
        return new RandomAccessFile(pty.slavePath().toFile(), "rw");
    }

    private static byte[] readExactly(Pty pty, int length) {
        StringBuilder arrived = new StringBuilder();
        byte[] buffer = new byte[64];
        while (arrived.length() < length) {
            int count = pty.read(buffer, 200);
            assertThat(count).isNotEqualTo(Pty.NO_CLIENT);
            arrived.append(new String(buffer, 0, count, StandardCharsets.ISO_8859_1));
        }
        return arrived.toString().getBytes(StandardCharsets.ISO_8859_1);
    }

    private static void setBaudAsAClientDoes(Path slave, int baud, int speedCode) throws IOException {
        int descriptor = LibC.check(LibC.open(slave.toString(), LibC.O_RDWR | LibC.O_NOCTTY), "open");
        try (Memory termios = new Memory(LibC.TERMIOS_BYTES)) {
            LibC.check(LibC.tcgetattr(descriptor, termios), "tcgetattr");
            termios.setInt(8, (termios.getInt(8) & ~0x100F) | speedCode);
            termios.setInt(52, baud);
            termios.setInt(56, baud);
            LibC.check(LibC.tcsetattr(descriptor, LibC.TCSANOW, termios), "tcsetattr");
        } finally {
            LibC.close(descriptor);
        }
    }

    private static byte[] everyByte() {
        byte[] bytes = new byte[256];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) i;
        }
        return bytes;
    }
}
