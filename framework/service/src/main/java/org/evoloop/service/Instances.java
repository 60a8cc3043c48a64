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
 * Finds the control sockets of instances: in {@code $XDG_RUNTIME_DIR/evoloop}, else {@code $RUNTIME_DIRECTORY}, which
 * systemd sets, else {@code evoloop-USER} in the directory for temporary files.
 *
 * <p>Threading: immutable.
 */
final class Instances {
    private static final String SOCKET = ".sock";

    /**
     * The sockets' directory of a unit with {@code RuntimeDirectory=evoloop}; processes outside the unit do not have
     * the variable.
     */
    private static final Path SYSTEM = Path.of("/run/evoloop");

    private final Map<String, String> environment;
    private final Path temporary;

    /** @param environment of the process */
    Instances(Map<String, String> environment) {
        this(environment, Path.of(System.getProperty("java.io.tmpdir"), "evoloop-" + System.getProperty("user.name")));
    }

    /** @param temporary this user's directory where anyone may create directories */
    Instances(Map<String, String> environment, Path temporary) {
        this.environment = environment;
        this.temporary = temporary;
    }

    /** @throws IllegalArgumentException if {@code name} is not a valid instance name */
    static void requireName(String name) {
        if (!name.matches("[A-Za-z0-9_][A-Za-z0-9_-]*")) {
            throw new IllegalArgumentException(
                    "'" + name + "' is not a name for an instance; use letters, digits, - and _, and no - in front, as "
                            + "in living-room");
        }
    }

    /** The directory for the sockets of instances in this environment. */
    Path directory() {
        Path own = own();
        return own != null ? own : temporary;
    }

    private @Nullable Path own() {
        String session = environment.getOrDefault("XDG_RUNTIME_DIR", "");
        if (!session.isEmpty()) {
            return Path.of(session, "evoloop");
        }
        // A unit with several directories gets all of them, separated by colons.
        String service = environment.getOrDefault("RUNTIME_DIRECTORY", "").split(":", 2)[0];
        return service.isEmpty() ? null : Path.of(service);
    }

    /**
     * The socket of an instance in {@code directory}.
     *
     * @throws IllegalArgumentException if the path would be too long for a socket
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

    /** The limit of Linux's {@code sockaddr_un}, including the final zero byte. */
    private static final int LONGEST_PATH = 108;

    /** The directories to search for an instance, the likeliest first. */
    List<Path> directories() {
        Set<Path> all = new LinkedHashSet<>();
        all.add(directory());
        all.add(SYSTEM);
        all.add(temporary);
        return List.copyOf(all);
    }

    /** All sockets found; not all of their instances need to be running. */
    List<Path> sockets() {
        List<Path> found = new ArrayList<>();
        for (Path directory : directories()) {
            if (directory.equals(temporary) && !PrivateDirectory.isOwn(directory)) {
                // Somebody else may have put it there, with a socket that answers in an instance's place.
                continue;
            }
            try (DirectoryStream<Path> files = Files.newDirectoryStream(directory, "*" + SOCKET)) {
                Set<Path> sorted = new TreeSet<>();
                files.forEach(sorted::add);
                found.addAll(sorted);
            } catch (IOException notThereOrNotOurs) {
                // There are no instances that this user may control.
            }
        }
        return found;
    }

    /** The directories whose instances this user may not see. */
    List<Path> closedDirectories() {
        return directories().stream()
                .filter(directory -> !directory.equals(temporary))
                .filter(directory -> Files.isDirectory(directory) && !Files.isReadable(directory))
                .toList();
    }

    /** The name of the instance with that socket. */
    static String nameOf(Path socket) {
        String file = String.valueOf(socket.getFileName());
        return file.substring(0, file.length() - SOCKET.length());
    }
}
