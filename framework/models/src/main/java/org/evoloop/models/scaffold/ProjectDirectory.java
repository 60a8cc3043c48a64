package org.evoloop.models.scaffold;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A generated project's directory. An unmodified copy of the generated files is kept in {@value #GENERATED}, so that
 * changes by the owner can be detected later.
 */
final class ProjectDirectory {
    /** Relative to the project's directory. */
    static final String GENERATED = ".scaffold";

    private static final String MODELS = "models/";
    private static final String SCRIPT = "mvnw";

    private final Path directory;
    private final List<String> report = new ArrayList<>();

    ProjectDirectory(Path directory) {
        this.directory = directory;
    }

    /** Whether the directory contains a generated project. */
    static boolean isProject(Path directory) {
        return Files.isDirectory(directory.resolve(GENERATED));
    }

    /** The text generated earlier as {@code path}; empty if there was none. */
    String generated(String path) throws IOException {
        Path kept = directory.resolve(GENERATED).resolve(path);
        return Files.exists(kept) ? Files.readString(kept) : "";
    }

    /**
     * Writes the project's new files, and updates those that its owner has not changed.
     *
     * @param files by path, with slashes
     * @return one line for each file that the owner has to know about
     * @throws IOException if a file cannot be written
     * @throws IllegalArgumentException if a model was changed both in the project and outside; nothing is written then
     */
    List<String> write(Map<String, byte[]> files) throws IOException {
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            requireModel(file.getKey(), file.getValue());
        }
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            String path = file.getKey();
            if (path.startsWith(GENERATED)) {
                put(directory.resolve(path), file.getValue());
            } else {
                write(path, file.getValue());
                put(directory.resolve(GENERATED).resolve(path), file.getValue());
            }
        }
        leftOver(files.keySet());
        if (!directory.resolve(SCRIPT).toFile().setExecutable(true)) {
            throw new IOException(directory.resolve(SCRIPT) + " cannot be made executable");
        }
        return report;
    }

    private void requireModel(String path, byte[] now) throws IOException {
        Path target = directory.resolve(path);
        if (path.startsWith(MODELS)
                && !path.endsWith(".txt")
                && Files.exists(target)
                && isOwners(path)
                && !Arrays.equals(Files.readAllBytes(target), now)) {
            throw new IllegalArgumentException("--update: " + target
                    + " was changed there; name it as ORIGINAL and NEW, or put the models that count in its place");
        }
    }

    /** Whether the file was written or changed by the owner. */
    private boolean isOwners(String path) throws IOException {
        Path before = directory.resolve(GENERATED).resolve(path);
        return !Files.exists(before) || Files.mismatch(before, directory.resolve(path)) >= 0;
    }

    private void write(String path, byte[] now) throws IOException {
        Path target = directory.resolve(path);
        Path before = directory.resolve(GENERATED).resolve(path);
        boolean changed = !Files.exists(before) || !Arrays.equals(Files.readAllBytes(before), now);
        if (!Files.exists(target)) {
            if (Files.exists(before)) {
                report.add("left out  " + path + ", which was removed");
            } else {
                put(target, now);
                report.add("new       " + path);
            }
        } else if (!isOwners(path)) {
            put(target, now);
            if (changed) {
                report.add("updated   " + path);
            }
        } else if (changed && !Arrays.equals(Files.readAllBytes(target), now)) {
            report.add("kept      " + path + ", which you changed; the new lines in it:");
            differences(generated(path), new String(now, StandardCharsets.UTF_8));
        }
    }

    private void differences(String before, String now) {
        List<String> old = before.lines().toList();
        List<String> fresh = now.lines().toList();
        old.stream().filter(line -> !fresh.contains(line)).forEach(line -> report.add("  - " + line.strip()));
        fresh.stream().filter(line -> !old.contains(line)).forEach(line -> report.add("  + " + line.strip()));
    }

    /** Reports files that would no longer be generated. They stay, since the owner's code may need them. */
    private void leftOver(Set<String> now) throws IOException {
        Path generated = directory.resolve(GENERATED);
        Set<String> before;
        try (Stream<Path> all = Files.walk(generated)) {
            before = all.filter(Files::isRegularFile)
                    .map(file -> generated.relativize(file).toString().replace('\\', '/'))
                    .collect(Collectors.toCollection(TreeSet::new));
        }
        before.removeIf(path -> now.contains(path) || now.contains(GENERATED + "/" + path));
        for (String path : before) {
            Files.delete(generated.resolve(path));
            if (Files.exists(directory.resolve(path))) {
                report.add("unneeded  " + path + "; remove it if your code does not need it");
            }
        }
    }

    private static void put(Path file, byte[] content) throws IOException {
        Files.createDirectories(file.resolveSibling(""));
        Files.write(file, content);
    }

    /** Collects the files for {@link #write}. */
    static final class Content {
        private final Map<String, byte[]> files = new LinkedHashMap<>();

        void text(String path, String content) {
            files.put(path, content.getBytes(StandardCharsets.UTF_8));
        }

        void bytes(String path, byte[] content) {
            files.put(path, content);
        }

        Map<String, byte[]> files() {
            return files;
        }
    }
}
