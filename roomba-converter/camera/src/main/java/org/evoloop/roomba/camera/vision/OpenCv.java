package org.evoloop.roomba.camera.vision;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.evoloop.roomba.camera.CameraException;
import org.jspecify.annotations.Nullable;

/**
 * The installed OpenCV, found and loaded at the first request. Names and classes differ between Debian releases, so
 * none are shipped: {@code opencv-460.jar} belongs to {@code libopencv_java460.so}.
 *
 * <p>The system properties {@code evoloop.opencv.classes} and {@code evoloop.opencv.natives} replace Debian's folders.
 *
 * @since 0.1
 */
public final class OpenCv {
    private static final String CLASSES = "/usr/share/java/opencv4";
    private static final String NATIVES = "/usr/lib/jni";
    private static final String IMPLEMENTATION = "org.evoloop.roomba.camera.opencv.OpenCvVision";

    /** One per process: a native library can be loaded only once. */
    private static @Nullable Vision loaded;

    private OpenCv() {}

    /**
     * Loads OpenCV if necessary.
     *
     * @throws CameraException if it is not installed or does not load; the message says what to install
     */
    public static synchronized Vision vision() {
        Vision vision = loaded;
        if (vision == null) {
            vision = load(
                    Path.of(System.getProperty("evoloop.opencv.classes", CLASSES)),
                    Path.of(System.getProperty("evoloop.opencv.natives", NATIVES)));
            loaded = vision;
        }
        return vision;
    }

    private static Vision load(Path classes, Path natives) {
        for (Path jar : jars(classes)) {
            Path library = natives.resolve(jar.getFileName()
                    .toString()
                    .replaceFirst("^opencv-", "libopencv_java")
                    .replaceFirst("\\.jar$", ".so"));
            if (Files.exists(library)) {
                return load(jar, library, classes);
            }
        }
        throw new CameraException("the camera needs OpenCV, and there is no opencv-*.jar in " + classes
                + " with its libopencv_java*.so in " + natives
                + "; run: sudo apt-get install --no-install-recommends libopencv-java");
    }

    /** The newest first, if there are several. */
    private static List<Path> jars(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().matches("opencv-\\d+\\.jar"))
                    .sorted((one, other) -> version(other) - version(one))
                    .toList();
        } catch (IOException absent) {
            return List.of();
        }
    }

    private static int version(Path jar) {
        return Integer.parseInt(jar.getFileName().toString().replaceAll("\\D", ""));
    }

    private static Vision load(Path jar, Path library, Path classes) {
        try {
            URL own = OpenCv.class.getProtectionDomain().getCodeSource().getLocation();
            // Never closed: it is needed until the process ends, like the native library.
            OpenCvLoader loader = new OpenCvLoader(new URL[] {own, jar.toUri().toURL()}, OpenCv.class.getClassLoader());
            return (Vision) loader.loadClass(IMPLEMENTATION)
                    .getConstructor(String.class)
                    .newInstance(library.toString());
        } catch (InvocationTargetException failed) {
            throw unusable(jar, classes, Optional.ofNullable(failed.getCause()).orElse(failed));
        } catch (IOException | ReflectiveOperationException | LinkageError failed) {
            throw unusable(jar, classes, failed);
        }
    }

    private static CameraException unusable(Path jar, Path folder, Throwable cause) {
        return new CameraException(
                "OpenCV of " + jar + " does not load (" + cause + "); run: sudo apt-get install --reinstall "
                        + "--no-install-recommends libopencv-java, or remove what is not Debian's from " + folder,
                cause);
    }
}
