package org.evoloop.studio;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.ModelException;
import org.evoloop.studio.Analysis.Written;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelReference;

/**
 * The folder whose files the studio shows and saves. No path leads out of it: neither an absolute one nor {@code ..} nor
 * a symbolic link. Hidden files, and those of other kinds, are not its business.
 *
 * <p>Threading: thread-safe. Of two saves of one file, the second finds that the file has changed.
 */
final class Folder {
    /** The largest text that is edited, in bytes. */
    static final int LARGEST = 1 << 20;

    /** How many files are listed. */
    static final int MOST_FILES = 2_000;

    private static final int DEEPEST = 12;
    private static final Pattern MODELS =
            Pattern.compile("(?i).*\\.(mmd|mermaid|puml|plantuml|pu|iuml|wsd|md|markdown|scxml|xml|xmi|uml|asta)");
    private static final Pattern DEVICE = Pattern.compile("(?i).*\\.ya?ml");
    private static final Pattern PROPERTIES = Pattern.compile("(?i).*\\.properties\\.txt");
    private static final Set<String> OF_TOOLS = Set.of("target", "build", "node_modules");
    private static final Set<PosixFilePermission> USUAL = PosixFilePermissions.fromString("rw-r--r--");

    private final Path root;

    /** A file's text and its version, which changes with its bytes. */
    record Read(String text, String version) {}

    /** @throws IOException if it is no folder; the message says what to do */
    Folder(Path directory) throws IOException {
        if (!Files.isDirectory(directory)) {
            throw new IOException(directory + " is not a folder; name one that holds models, or create it");
        }
        root = directory.toRealPath();
    }

    Path root() {
        return root;
    }

    /** Whether it is a file of models by its name. */
    static boolean isOfModels(String path) {
        return MODELS.matcher(path).matches();
    }

    /** Whether it could be a device file by its name. */
    static boolean isDevice(String path) {
        return DEVICE.matcher(path).matches();
    }

    /** The files that could be shown, in order. */
    List<String> files() {
        List<String> found = new ArrayList<>();
        try {
            Files.walkFileTree(root, Set.of(), DEEPEST, new SimpleFileVisitor<>() {
                @Override
                public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
                    String name = String.valueOf(folder.getFileName());
                    boolean skipped = !folder.equals(root) && (name.startsWith(".") || OF_TOOLS.contains(name));
                    return skipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
                }

                @Override
                public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                    String path = root.relativize(file).toString();
                    if (attributes.isRegularFile() && isShown(path)) {
                        found.add(path);
                    }
                    return found.size() < MOST_FILES ? FileVisitResult.CONTINUE : FileVisitResult.TERMINATE;
                }

                @Override
                public FileVisitResult visitFileFailed(Path file, IOException failure) {
                    return FileVisitResult.CONTINUE;
                }
            });
        } catch (IOException unreadable) {
            throw failed(unreadable);
        }
        found.sort(null);
        return found;
    }

    private static boolean isShown(String path) {
        return !Path.of(path).getFileName().toString().startsWith(".")
                && (isOfModels(path)
                        || isDevice(path)
                        || PROPERTIES.matcher(path).matches());
    }

    /**
     * The file at {@code path}, which need not exist.
     *
     * @throws RequestException if it would be outside of the folder, hidden, or of another kind
     */
    Path require(String path) {
        try {
            Path relative = Path.of(path);
            boolean outside = path.isEmpty() || relative.isAbsolute() || path.indexOf('\\') >= 0;
            for (Path part : relative) {
                outside |= part.toString().startsWith(".");
            }
            if (outside || !isShown(path)) {
                throw refused(path);
            }
            Path file = root.resolve(relative);
            if (!existing(file).toRealPath().startsWith(root)) {
                throw refused(path);
            }
            return file;
        } catch (InvalidPathException | IOException unusable) {
            throw refused(path);
        }
    }

    /** The file, or else the innermost folder around it that exists. */
    private Path existing(Path file) {
        Path parent = file.getParent();
        boolean exists = Files.exists(file, LinkOption.NOFOLLOW_LINKS);
        return exists || parent == null ? file : existing(parent);
    }

    private static RequestException refused(String path) {
        return new RequestException(
                RequestException.FORBIDDEN,
                "'" + path + "' is not a file of models, a device file or one of properties in this folder");
    }

    /** The text of a file. */
    Read read(String path) {
        Path file = require(path);
        try {
            if (!Files.isRegularFile(file)) {
                throw new RequestException(RequestException.NOT_FOUND, "there is no file " + path);
            }
            byte[] bytes = bytes(file);
            if (bytes.length > LARGEST) {
                throw new RequestException(path + " is larger than 1 MB; edit it in its own tool");
            }
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
            return new Read(text, version(bytes));
        } catch (CharacterCodingException binary) {
            throw new RequestException(path + " is no text in UTF-8; edit it in its own tool");
        } catch (IOException unreadable) {
            throw failed(unreadable);
        }
    }

    private static byte[] bytes(Path file) throws IOException {
        try (var in = Files.newInputStream(file)) {
            return in.readNBytes(LARGEST + 1);
        }
    }

    /**
     * Writes a file, entirely or not at all.
     *
     * @param version of what was read; empty for a file that does not exist yet
     * @return the new version
     * @throws RequestException with the text on disk if that is another version
     */
    synchronized String write(String path, String text, String version) {
        Path file = require(path);
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length > LARGEST) {
            throw new RequestException("the text is larger than 1 MB; split it");
        }
        try {
            boolean exists = Files.exists(file);
            Read there = exists ? read(path) : new Read("", "");
            if (!there.version().equals(version)) {
                throw new RequestException(
                        RequestException.CONFLICT,
                        new JsonObject().put("text", there.text()).put("version", there.version()),
                        path + " has changed on disk");
            }
            Path target = exists ? file.toRealPath() : file;
            Set<PosixFilePermission> permissions = exists ? Files.getPosixFilePermissions(target) : USUAL;
            // It is replaced, which its own permissions would not prevent.
            if (!permissions.contains(PosixFilePermission.OWNER_WRITE) || (exists && !Files.isWritable(target))) {
                throw new RequestException(
                        RequestException.FORBIDDEN, path + " is read-only; allow its owner to write it, then save");
            }
            Path folder = target.getParent();
            Files.createDirectories(folder);
            Path fresh = Files.createTempFile(folder, "." + target.getFileName(), "");
            try {
                Files.write(fresh, bytes);
                Files.setPosixFilePermissions(fresh, permissions);
                Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE);
            } finally {
                Files.deleteIfExists(fresh);
            }
            return version(bytes);
        } catch (IOException unwritable) {
            throw failed(unwritable);
        }
    }

    /**
     * The machines of a file on disk.
     *
     * @throws ModelException whose message begins with {@code path}
     */
    ModelFile models(String path) {
        Path file = require(path);
        try {
            return ModelFile.read(file);
        } catch (ModelException reported) {
            throw new ModelException(String.valueOf(reported.getMessage()).replace(file.toString(), path), reported);
        }
    }

    /** The properties in the file beside a model; empty if there is none. */
    Written propertiesOf(String path, String machine) {
        Path model = require(path);
        Optional<String> name = machine.isEmpty() ? Optional.empty() : Optional.of(machine);
        Path beside = new ModelReference(model, name).beside(".properties.txt");
        String relative = root.relativize(beside).toString();
        return new Written(
                relative, Files.isRegularFile(beside) ? read(relative).text() : "");
    }

    private static String version(byte[] bytes) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes), 0, 16);
        } catch (NoSuchAlgorithmException impossible) {
            throw new AssertionError("every Java has SHA-256", impossible);
        }
    }

    private RequestException failed(IOException failure) {
        String message = String.valueOf(failure.getMessage()).replace(root + "/", "");
        return new RequestException("the folder cannot be used: " + message);
    }
}
