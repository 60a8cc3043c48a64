package org.evoloop.natives;

import static org.assertj.core.api.Assertions.assertThat;

import com.fazecast.jSerialComm.SerialPort;
import com.sun.jna.NativeLibrary;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Modules hide their resources, such as native libraries, from each other. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class ModulePathTest {
    private static final String MODULE = "org.evoloop.natives";

    /** Loads both libraries, as a module. */
    static final class Program {
        public static void main(String[] arguments) throws Exception {
            NativeLibraries.loadSerial();
            System.out.println(Program.class.getModule().getName() + " loaded " + SerialPort.getVersion());
        }
    }

    @Test
    void nativeLibrariesAreLoadedOnTheModulePathToo() throws Exception {
        String modules =
                String.join(":", place(NativeLibraries.class), place(NativeLibrary.class), place(SerialPort.class));
        Process program = new ProcessBuilder(List.of(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "--enable-native-access=com.sun.jna,com.fazecast.jSerialComm," + MODULE,
                        "-p",
                        modules,
                        "--add-modules",
                        "com.fazecast.jSerialComm",
                        "--patch-module",
                        MODULE + "=" + place(ModulePathTest.class),
                        "-m",
                        MODULE + "/" + Program.class.getName()))
                .redirectErrorStream(true)
                .start();
        String said = new String(program.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(program.waitFor()).as(said).isZero();
        assertThat(said).startsWith(MODULE + " loaded ");
    }

    private static String place(Class<?> type) throws Exception {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI())
                .toString();
    }
}
