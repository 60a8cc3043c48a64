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
import java.util.function.Predicate;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.testkit.ConverterHarness;

/**
 * The framework that this program runs with, and its test kit, as a Maven repository in a directory, so that a project needs
 * nobody else's. Their version holds a mark of their content: what Maven has kept of another one is never taken for it.
 */
final class FrameworkRepository {
    private static final String OURS = "org/evoloop/";
    private static final List<String> TOOL = List.of("org/evoloop/models/", "org/evoloop/program/");
    private static final String KIT = "org/evoloop/testkit/";
    private static final int MARK_DIGITS = 10;

    private final byte[] framework;
    private final byte[] kit;
    private final String version;

    private FrameworkRepository(byte[] framework, byte[] kit) {
        this.framework = framework;
        this.kit = kit;
        this.version = Versions.get("evoloop").replace("-SNAPSHOT", "") + "-" + mark(framework, kit);
    }

    /** Packs both. @throws IOException if their classes cannot be read */
    static FrameworkRepository pack() throws IOException {
        return new FrameworkRepository(
                jar(classes(
                        SystemEventConverter.class,
                        name -> !name.startsWith(KIT) && TOOL.stream().noneMatch(name::startsWith))),
                jar(classes(ConverterHarness.class, name -> name.startsWith(KIT))));
    }

    /** The version of both in this repository. */
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
        pom(content, folder, "evoloop-testkit", Template.text("poms/framework/testkit/pom.xml"));
        content.bytes(path(folder, "framework") + ".jar", framework);
        content.bytes(path(folder, "evoloop-testkit") + ".jar", kit);
    }

    private void pom(ProjectDirectory.Content content, String folder, String artifact, String pom) {
        String mine = pom.replace(Versions.tag("evoloop"), "<version>" + version + "</version>");
        content.text(path(folder, artifact) + ".pom", mine);
    }

    private String path(String folder, String artifact) {
        return folder + OURS + artifact + "/" + version + "/" + artifact + "-" + version;
    }

    /** By path in a jar. They lie in a directory while they are being built, else in a jar. */
    private static Map<String, byte[]> classes(Class<?> oneOfThem, Predicate<String> wanted) throws IOException {
        CodeSource source = oneOfThem.getProtectionDomain().getCodeSource();
        if (source == null) {
            throw new IOException("nobody knows where the framework's classes lie; run this program from its jar");
        }
        Path place = Path.of(URI.create(source.getLocation().toString()));
        if (Files.isDirectory(place)) {
            return below(place, wanted);
        }
        try (FileSystem opened = FileSystems.newFileSystem(place)) {
            return below(opened.getPath("/"), wanted);
        }
    }

    private static Map<String, byte[]> below(Path root, Predicate<String> wanted) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(root.resolve(OURS))) {
            files = all.filter(Files::isRegularFile).toList();
        }
        Map<String, byte[]> classes = new TreeMap<>();
        for (Path file : files) {
            String name = root.relativize(file).toString().replace('\\', '/');
            if (wanted.test(name)) {
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

    private static String mark(byte[]... jars) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (byte[] jar : jars) {
                digest.update(jar);
            }
            return HexFormat.of().formatHex(digest.digest()).substring(0, MARK_DIGITS);
        } catch (NoSuchAlgorithmException broken) {
            throw new IllegalStateException("every Java has SHA-256", broken);
        }
    }
}
