package org.evoloop.service;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/**
 * Where instances have their control sockets: {@code $XDG_RUNTIME_DIR/evoloop}, else {@code $RUNTIME_DIRECTORY}, which
 * systemd sets, else {@code evoloop-USER} in the directory for temporary files.
 *
 * <p>Threading: immutable.
 */
final class Instances {
    private static final String SOCKET = ".sock";

    /** Where a unit with {@code RuntimeDirectory=evoloop} has its sockets; those outside are not told so. */
    private static final Path SYSTEM = Path.of("/run/evoloop");

    private final Map<String, String> environment;

    /** @param environment of the process */
    Instances(Map<String, String> environment) {
        this.environment = environment;
    }

    /** @throws IllegalArgumentException if {@code name} is none for an instance */
    static void requireName(String name) {
        if (!name.matches("[A-Za-z0-9_][A-Za-z0-9_-]*")) {
            throw new IllegalArgumentException(
                    "'" + name + "' is no name for an instance; use letters, digits, - and _, and"
                            + " no - in front, as in living-room");
        }
    }

    /** Where an instance of this environment has its socket. */
    Path directory() {
        Path own = own();
        return own != null ? own : temporary();
    }

    private @Nullable Path own() {
        String session = environment.getOrDefault("XDG_RUNTIME_DIR", "");
        if (!session.isEmpty()) {
            return Path.of(session, "evoloop");
        }
        // One that has several is told all of them.
        String service = environment.getOrDefault("RUNTIME_DIRECTORY", "").split(":", 2)[0];
        return service.isEmpty() ? null : Path.of(service);
    }

    private static Path temporary() {
        return Path.of(System.getProperty("java.io.tmpdir"), "evoloop-" + System.getProperty("user.name"));
    }

    /**
     * The socket of an instance in {@code directory}.
     *
     * @throws IllegalArgumentException if the path would be longer than one of a socket may be
     */
    static Path socket(Path directory, String name) {
        Path socket = directory.resolve(name + SOCKET);
        int length = socket.toString().getBytes(StandardCharsets.UTF_8).length;
        if (length >= LONGEST_PATH) {
            throw new IllegalArgumentException("the control socket " + socket + " would have a path of " + length
                    + " bytes, and " + (LONGEST_PATH - 1)
                    + " are allowed; choose a shorter name, or set XDG_RUNTIME_DIR to a"
                    + " shorter directory");
        }
        return socket;
    }

    /** Of Linux's {@code sockaddr_un}, with the byte that ends it. */
    private static final int LONGEST_PATH = 108;

    /** Where to look for an instance, the likeliest first. */
    List<Path> directories() {
        Set<Path> all = new LinkedHashSet<>();
        all.add(directory());
        all.add(SYSTEM);
        all.add(temporary());
        return List.copyOf(all);
    }

    /** The sockets of the instances that may be looked for, by no means all of which need run. */
    List<Path> sockets() {
        List<Path> found = new ArrayList<>();
        for (Path directory : directories()) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(directory, "*" + SOCKET)) {
                Set<Path> sorted = new TreeSet<>();
                files.forEach(sorted::add);
                found.addAll(sorted);
            } catch (IOException notThereOrNotOurs) {
                // Nobody who may be asked has a socket there.
            }
        }
        return found;
    }

    /** The name of the instance with that socket. */
    static String nameOf(Path socket) {
        String file = String.valueOf(socket.getFileName());
        return file.substring(0, file.length() - SOCKET.length());
    }
}
