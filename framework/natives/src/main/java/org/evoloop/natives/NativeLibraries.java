package org.evoloop.natives;

import com.fazecast.jSerialComm.SerialPort;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Platform;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.module.ModuleReader;
import java.util.HashMap;
import java.util.Map;
import java.util.UUID;
import org.jspecify.annotations.Nullable;

/**
 * Loads the native parts of JNA and jSerialComm. By default both unpack them under predictable names, and jSerialComm
 * loads any file that it finds there: in {@code /tmp} that may be another user's. Here they are unpacked from the jar
 * into a {@link PrivateFolder}, which is deleted after loading.
 *
 * <p>On systems other than Linux the folder for temporary files belongs to the user, and the libraries use their
 * defaults.
 *
 * <p>Threading: thread-safe; callers wait for a library that is being loaded.
 *
 * @since 0.1
 */
public final class NativeLibraries {
    /** jSerialComm's names of machines, by JNA's. Machines with "arm" use hard floats, as in Raspberry Pi OS. */
    private static final Map<String, String> MACHINES = Map.of(
            "linux-x86-64", "x86_64",
            "linux-x86", "x86",
            "linux-aarch64", "armv8_64",
            "linux-arm", "armv6hf",
            "linux-armel", "armv5",
            "linux-ppc64le", "ppc64le");

    /** The name under which the system finds the C library without a search by JNA. */
    public static final String C_LIBRARY = Platform.isLinux() ? "libc.so.6" : Platform.C_LIBRARY_NAME;

    private static boolean jnaLoaded;
    private static boolean serialLoaded;

    private NativeLibraries() {}

    /**
     * Loads JNA. Call it before any of its classes is used.
     *
     * @throws IOException if that fails; the message says why
     */
    public static synchronized void loadJna() throws IOException {
        if (!jnaLoaded) {
            load(
                    NativeLibrary.class,
                    "com/sun/jna/" + Platform.RESOURCE_PREFIX + "/libjnidispatch.so",
                    NativeLibraries::loadJna);
            jnaLoaded = true;
        }
    }

    private static void loadJna(File library) {
        // Fails if the library cannot be loaded; JNA itself would search elsewhere. JNA then finds it already loaded.
        System.load(library.toString());
        during(
                Map.of(
                        "jna.boot.library.path",
                        library.getParent(),
                        "jna.nounpack",
                        "true",
                        // Otherwise JNA would run ldconfig to find the library path, which takes longer than everything
                        // else.
                        "jna.platform.library.path",
                        ""),
                () -> NativeLibrary.getInstance(C_LIBRARY));
    }

    /**
     * Loads jSerialComm. Call it before any of its classes is used.
     *
     * @throws IOException if that fails; the message says why
     */
    public static synchronized void loadSerial() throws IOException {
        loadJna();
        if (!serialLoaded) {
            String machine = MACHINES.getOrDefault(Platform.RESOURCE_PREFIX, Platform.RESOURCE_PREFIX);
            load(SerialPort.class, "Linux/" + machine + "/libjSerialComm.so", NativeLibraries::loadSerial);
            serialLoaded = true;
        }
    }

    private static void loadSerial(File library) {
        // As for JNA. System.load would initialise jSerialComm's classes too early; opening the library does not.
        NativeLibrary.getInstance(library.toString()).close();
        during(
                Map.of(
                        "jSerialComm.library.path",
                        library.getParent(),
                        // jSerialComm empties old folders of this name, following links in them. A random name has
                        // none.
                        "fazecast.jSerialComm.appid",
                        UUID.randomUUID().toString()),
                SerialPort::getVersion);
    }

    /** Loads a library from a file. */
    private interface Loading {
        void from(File library);
    }

    private static void load(Class<?> user, String resource, Loading loading) throws IOException {
        if (!Platform.isLinux()) {
            return;
        }
        String file = resource.substring(resource.lastIndexOf('/') + 1);
        try (PrivateFolder folder = PrivateFolder.make()) {
            File library = folder.file(file);
            unpack(user, resource, library);
            loading.from(library);
        } catch (IOException | UnsatisfiedLinkError failure) {
            throw new IOException(
                    "the native library " + file + " cannot be unpacked and loaded (" + failure.getMessage()
                            + "); name a folder that can be written to with java -Djava.io.tmpdir=FOLDER",
                    failure);
        }
    }

    /**
     * Reads from the jar of the class that uses the library. A module's resources can be read only through its reader.
     */
    private static void unpack(Class<?> user, String resource, File target) throws IOException {
        Module module = user.getModule();
        if (!module.isNamed()) {
            try (InputStream library = user.getResourceAsStream("/" + resource)) {
                copy(library, target);
            }
            return;
        }
        try (ModuleReader reader = module.getLayer()
                        .configuration()
                        .findModule(module.getName())
                        .orElseThrow()
                        .reference()
                        .open();
                InputStream library = reader.open(resource).orElse(null)) {
            copy(library, target);
        }
    }

    private static void copy(@Nullable InputStream library, File target) throws IOException {
        if (library == null) {
            throw new IOException("there is none for this machine, " + Platform.RESOURCE_PREFIX);
        }
        try (OutputStream file = new FileOutputStream(target)) {
            library.transferTo(file);
        }
    }

    /**
     * Sets system properties during the initialisation. Both libraries read their settings only once, when their
     * classes are initialised.
     */
    private static void during(Map<String, String> settings, Runnable initialisation) {
        Map<String, @Nullable String> before = new HashMap<>();
        settings.forEach((name, value) -> before.put(name, System.setProperty(name, value)));
        try {
            initialisation.run();
        } finally {
            before.forEach(NativeLibraries::restore);
        }
    }

    private static void restore(String name, @Nullable String value) {
        if (value == null) {
            System.clearProperty(name);
        } else {
            System.setProperty(name, value);
        }
    }
}
