package org.evoloop.config;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Map;
import java.util.Optional;

/**
 * A secret, such as a password: it is in a file that an option names, else in the environment, and never in the
 * configuration.
 *
 * <p>Threading: immutable.
 *
 * @param file the option that names the file; called {@code NAME-file}
 * @param variable the variable of the environment
 * @since 0.1
 */
public record Secret(Option<Path> file, String variable) {
    private static final int LONGEST = 4096;

    /**
     * A secret called {@code name}.
     *
     * @param name without dashes, such as {@code mqtt-password}
     */
    public static Secret named(String name, String description, String variable) {
        return new Secret(Option.path(name + "-file", "FILE", description), variable);
    }

    /** The name that may be mistaken for the option's. */
    String name() {
        return file.name().replaceFirst("-file$", "");
    }

    /**
     * The secret; empty if there is none.
     *
     * @throws IllegalArgumentException if its file cannot be read, or does not hold one
     */
    public Optional<String> in(Settings settings) {
        Optional<Path> named = settings.get(file);
        return named.isPresent()
                ? Optional.of(settings.secret(
                        named.get(), from -> read(from, "--" + file.name() + " is " + from + ", which ")))
                : Optional.ofNullable(settings.environment().get(variable)).filter(text -> !text.isEmpty());
    }

    /**
     * The secret in a file that is named elsewhere than by an option.
     *
     * @throws IllegalArgumentException if the file cannot be read, or does not hold one
     */
    public static String read(Path from) {
        return read(from, from + " ");
    }

    /** Whether all users of this computer may read a secret's file, as far as the file system tells. */
    public static boolean isShared(Path file) {
        try {
            return Files.getPosixFilePermissions(file).contains(PosixFilePermission.OTHERS_READ);
        } catch (IOException | UnsupportedOperationException notTold) {
            return false;
        }
    }

    /** @param subject of each message */
    private static String read(Path from, String subject) {
        try {
            byte[] bytes = FileBytes.first(LONGEST + 1, from);
            if (bytes.length > LONGEST) {
                throw new IllegalArgumentException(subject + "is larger than " + LONGEST
                        + " bytes; name a file that holds nothing but the secret");
            }
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString()
                    .strip();
            if (text.isEmpty()) {
                throw new IllegalArgumentException(subject + "is empty; write the secret into it");
            }
            return text;
        } catch (CharacterCodingException otherEncoding) {
            throw new IllegalArgumentException(subject + "is not text in UTF-8; save it in this encoding");
        } catch (IOException unreadable) {
            throw new IllegalArgumentException(
                    subject + "cannot be read; check that it is there, and that this program's user may read it");
        }
    }

    /** Its origin: {@code (set, from FILE)}; never its value. */
    String shown(Settings settings) {
        Optional<Path> named = settings.get(file);
        if (named.isPresent()) {
            return "(set, from " + named.get() + ")";
        }
        Map<String, String> environment = settings.environment();
        return environment.getOrDefault(variable, "").isEmpty()
                ? "(not set; it may be in the environment, " + variable + ")"
                : "(set, from the environment, " + variable + ")";
    }
}
