package org.evoloop.models.scaffold;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.evoloop.converter.SystemEventConverter;

/**
 * The framework that this program runs with, as a Maven repository in a directory, so that a project needs nobody else's.
 * Its version holds a mark of its content: what Maven has kept of another one is never taken for it.
 */
final class FrameworkRepository {
    private static final String OURS = "org/evoloop/";
    private static final String TOOL = "org/evoloop/models/";
    private static final int MARK_DIGITS = 10;

    private final byte[] jar;
    private final String version;

    private FrameworkRepository(byte[] jar, String version) {
        this.jar = jar;
        this.version = version;
    }

    /** Packs the framework. @throws IOException if its classes cannot be read */
    static FrameworkRepository pack() throws IOException {
        byte[] jar = jar(classes());
        return new FrameworkRepository(jar, Versions.get("evoloop").replace("-SNAPSHOT", "") + "-" + mark(jar));
    }

    /** The framework's version in this repository. */
    String version() {
        return version;
    }

    /**
     * Adds its files.
     *
     * @param folder ends in a slash
     */
    void addTo(ProjectDirectory.Content content, String folder) {
        pom(content, folder, "evoloop", Template.text("poms/pom.xml"));
        pom(content, folder, "framework", Template.text("poms/framework/pom.xml"));
        content.bytes(path(folder, "framework") + ".jar", jar);
    }

    private void pom(ProjectDirectory.Content content, String folder, String artifact, String pom) {
        String mine = pom.replace(Versions.tag("evoloop"), "<version>" + version + "</version>");
        content.text(path(folder, artifact) + ".pom", mine);
    }

    private String path(String folder, String artifact) {
        return folder + OURS + artifact + "/" + version + "/" + artifact + "-" + version;
    }

    /** By path in a jar. They lie in a directory while the framework is being built, else in a jar. */
    private static Map<String, byte[]> classes() throws IOException {
        CodeSource source = SystemEventConverter.class.getProtectionDomain().getCodeSource();
        if (source == null) {
            throw new IOException("nobody knows where the framework's classes lie; run this program from its jar");
        }
        Path place = Path.of(URI.create(source.getLocation().toString()));
        if (Files.isDirectory(place)) {
            return below(place);
        }
        try (FileSystem opened = FileSystems.newFileSystem(place)) {
            return below(opened.getPath("/"));
        }
    }

    private static Map<String, byte[]> below(Path root) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(root.resolve(OURS))) {
            files = all.filter(Files::isRegularFile).toList();
        }
        Map<String, byte[]> classes = new TreeMap<>();
        for (Path file : files) {
            String name = root.relativize(file).toString().replace('\\', '/');
            if (!name.startsWith(TOOL)) {
                classes.put(name, Files.readAllBytes(file));
            }
        }
        return classes;
    }

    /** The same classes make the same jar. */
    private static byte[] jar(Map<String, byte[]> classes) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            for (Map.Entry<String, byte[]> each : classes.entrySet()) {
                ZipEntry entry = new ZipEntry(each.getKey());
                entry.setTime(0);
                zip.putNextEntry(entry);
                zip.write(each.getValue());
            }
        }
        return bytes.toByteArray();
    }

    private static String mark(byte[] jar) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(jar);
            return HexFormat.of().formatHex(digest).substring(0, MARK_DIGITS);
        } catch (NoSuchAlgorithmException broken) {
            throw new IllegalStateException("every Java has SHA-256", broken);
        }
    }
}
