package org.evoloop.roomba.camera;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The source of frames.
 *
 * @param text depending on the kind, the device's path, the URL, the file, or the pattern of an image sequence
 * @since 0.1
 */
public record CameraSource(Kind kind, String text) {
    /** The name of the simulated robot's own camera. */
    public static final String SIMULATED = "sim";

    /** A host and its port, without a login before it. */
    private static final String HOST = "(?:[A-Za-z0-9._-]+|\\[[0-9A-Fa-f:.]+])(?::[0-9]{1,5})?";

    private static final Pattern NUMBER = Pattern.compile("\\d{1,3}");
    private static final Pattern SCHEME = Pattern.compile("[a-zA-Z][a-zA-Z0-9+.-]*://.*");
    private static final Pattern SEQUENCE = Pattern.compile(".*%0?\\d*d.*");

    /** The kind of a source. */
    public enum Kind {
        /** A camera of this machine, by Video4Linux. */
        DEVICE,
        /** A camera in the network: HTTP with Motion JPEG. */
        URL,
        /** A recording, or a single picture. */
        FILE,
        /** Pictures with a number in their names, such as {@code frames/%04d.png}. */
        IMAGE_SEQUENCE,
        /** The camera of the simulated robot; the program that starts the robot knows its URL. */
        SIMULATED
    }

    /**
     * Parses a user's text for a source: {@code /dev/video0} or {@code 0}, a URL, a file, a pattern, or {@code sim}.
     *
     * @throws CameraException if it is none of them
     */
    public static CameraSource parse(String text) {
        if (text.equals(SIMULATED)) {
            return new CameraSource(Kind.SIMULATED, text);
        }
        if (NUMBER.matcher(text).matches()) {
            return new CameraSource(Kind.DEVICE, "/dev/video" + Integer.parseInt(text));
        }
        if (text.startsWith("/dev/")) {
            return new CameraSource(Kind.DEVICE, text);
        }
        if (SCHEME.matcher(text).matches()) {
            String scheme = text.substring(0, text.indexOf(':')).toLowerCase(Locale.ROOT);
            if (!scheme.equals("http") && !scheme.equals("https")) {
                throw new CameraException(
                        "camera " + masked(text) + ": " + scheme + " is not supported; give a URL that begins with "
                                + "http:// or https:// and answers with Motion JPEG");
            }
            return new CameraSource(Kind.URL, text);
        }
        if (text.isBlank()) {
            throw new CameraException("the camera has no name; give a device such as /dev/video0, a URL, a file, "
                    + "numbered pictures, or sim");
        }
        return new CameraSource(SEQUENCE.matcher(text).matches() ? Kind.IMAGE_SEQUENCE : Kind.FILE, text);
    }

    /** Whether frames come by themselves and old ones are useless; a recording waits for its reader. */
    public boolean isLive() {
        return kind == Kind.DEVICE || kind == Kind.URL || kind == Kind.SIMULATED;
    }

    /** Why it cannot be opened, as far as the file system shows, with the remedy. */
    public Optional<String> obstacle() {
        if (kind != Kind.DEVICE && kind != Kind.FILE) {
            return Optional.empty();
        }
        Path path = Path.of(text);
        boolean device = kind == Kind.DEVICE;
        if (!Files.exists(path)) {
            return Optional.of("does not exist; "
                    + (device ? "plug the camera in, or see ls /dev/v4l/by-id" : "correct the path"));
        }
        if (!Files.isReadable(path)) {
            return Optional.of(
                    "may not be read; " + (device ? "sudo usermod -aG video $USER, and log in again" : "chmod +r"));
        }
        return Files.isDirectory(path) ? Optional.of("is a folder; name a file in it") : Optional.empty();
    }

    /** The source for messages, without the password that a URL may hold. */
    @Override
    public String toString() {
        return masked(text);
    }

    /** A source's text without the password that a URL may hold. */
    public static String masked(String text) {
        return SCHEME.matcher(text).matches()
                ? text.replaceFirst("://(?!" + HOST + "(?:[/?#]|$)).*@", "://***@")
                        .replaceFirst("\\?.*", "?***")
                : text;
    }
}
