package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.natives.Pty;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Every reason why a port cannot be opened, with the message that users see. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class SerialFaultsTest {
    @TempDir
    Path folder;

    @Test
    void aMissingPortNamesThoseThatExist() {
        assertThat(refusal("/dev/ttyMissing", Fault.NO_SUCH_PORT))
                .startsWith("serial port /dev/ttyMissing at 115200 baud does not exist; plug the cable in, or ")
                .endsWith(choice());
        assertThat(refusal("ttyMissing", Fault.NO_SUCH_PORT)).startsWith("serial port ttyMissing at 115200 baud");
    }

    @Test
    void aMissingPathIsNeverTakenForThePortOfTheSameName() throws IOException {
        try (Pty pty = Pty.open()) {
            assertThat(pty.slavePath()).exists();
            refusal(folder.resolve("pts").resolve("ptmx").toString(), Fault.NO_SUCH_PORT);
            refusal(folder.resolve("tty").toString(), Fault.NO_SUCH_PORT);
        }
    }

    @Test
    void aSymlinkToAPulledCableIsAMissingPort() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("device"), folder.resolve("gone"));
        refusal(link.toString(), Fault.NO_SUCH_PORT);
    }

    @Test
    void filesFoldersAndOtherDevicesAreNoSerialPorts() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "precious");
        assertThat(refusal(file.toString(), Fault.NOT_A_SERIAL_PORT))
                .isEqualTo(file + " is not a serial port; " + choice());
        assertThat(file).hasContent("precious");
        refusal(folder.toString(), Fault.NOT_A_SERIAL_PORT);
        refusal("/dev/null", Fault.NOT_A_SERIAL_PORT);
    }

    @Test
    void aPortOfThisProgramIsBusyUntilItsLinkIsClosed() throws IOException {
        try (Pty pty = Pty.open()) {
            String port = pty.path().toString();
            Link first = SerialLink.open(new SerialSettings(port));
            assertThat(refusal(port, Fault.BUSY))
                    .isEqualTo("serial port " + port + " at 115200 baud is in use by this program; end it first");
            first.close();
            try (Link second = SerialLink.open(new SerialSettings(port))) {
                assertThat(second.loss()).isNull();
            }
        }
    }

    @Test
    void aPortThatAnotherProgramHasLockedIsBusy() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/flock")), "needs the flock tool");
        try (Pty pty = Pty.open()) {
            String port = pty.path().toString();
            Process holder = new ProcessBuilder("/usr/bin/flock", port, "sh", "-c", "echo locked; read end")
                    .redirectErrorStream(true)
                    .start();
            try {
                byte[] locked = holder.getInputStream().readNBytes("locked".length());
                assertThat(new String(locked, StandardCharsets.UTF_8)).isEqualTo("locked");
                assertThat(refusal(port, Fault.BUSY)).contains("flock (process " + holder.pid() + ")");
            } finally {
                holder.destroy();
            }
        }
    }

    @Test
    void aPortOfOthersNamesTheGroupToJoin() throws IOException {
        assumeFalse("root".equals(System.getProperty("user.name")), "root may use every port");
        try (Pty pty = Pty.open()) {
            String port = pty.path().toString();
            Files.setPosixFilePermissions(pty.slavePath(), PosixFilePermissions.fromString("---rw----"));
            assertThat(refusal(port, Fault.NO_PERMISSION)).contains("sudo usermod -aG ");
            Files.setPosixFilePermissions(pty.slavePath(), PosixFilePermissions.fromString("---------"));
            assertThat(refusal(port, Fault.NO_PERMISSION)).contains("is reserved for ");
        }
    }

    @Test
    void everySystemErrorHasItsWords() {
        SerialSettings settings = new SerialSettings("/dev/ttyMissing").withBaud(250_000);
        Path device = Path.of("/dev/ttyMissing");
        String user = System.getProperty("user.name");
        assertThat(SerialFaults.notOpened(settings, device, 13))
                .hasMessage("serial port /dev/ttyMissing at 250000 baud may not be used by " + user
                        + "; run 'sudo usermod -aG dialout " + user + "', then log out and in again");
        assertThat(SerialFaults.notOpened(settings, device, 16).getMessage())
                .contains("in use by another program, such as a terminal program, ModemManager");
        assertThat(SerialFaults.notOpened(settings, device, 5).fault()).isEqualTo(Fault.HUNG_UP);
        assertThat(SerialFaults.notOpened(settings, device, 22))
                .hasMessage("serial port /dev/ttyMissing at 250000 baud cannot be set up (system error 22); try "
                        + "another baud rate, or unplug the cable and plug it in again");
    }

    @Test
    void aPortThatWasRefusedCanBeOpenedLater() throws IOException {
        Path path = folder.resolve("device");
        refusal(path.toString(), Fault.NO_SUCH_PORT);
        try (Pty pty = Pty.open(path)) {
            Link link = SerialLink.open(new SerialSettings(path.toString()));
            assertThat(pty.clientPresent()).isTrue();
            link.close();
            assertThat(pty.clientPresent()).isFalse();
        }
    }

    private static String choice() {
        return SerialLink.available().isEmpty()
                ? "check the adapter: this computer shows no serial port"
                : "choose one of: " + String.join(", ", SerialLink.available());
    }

    private static String refusal(String port, Fault fault) {
        LinkException refusal =
                catchThrowableOfType(LinkException.class, () -> SerialLink.open(new SerialSettings(port)));
        assertThat(refusal).isNotNull();
        assertThat(refusal.fault()).isEqualTo(fault);
        return String.valueOf(refusal.getMessage());
    }
}
