package org.evoloop.studio;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.evoloop.config.ConfigException;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.Scenario;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.device.file.Problems;
import org.evoloop.device.file.Section;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.ModelException;

/** Reads a device file that may not be saved yet, beside models that may not be saved either. */
final class DeviceTexts {
    private static final Pattern MISTAKE = Pattern.compile("[^\\n]*?:(\\d{1,9}): (.*)");

    private DeviceTexts() {}

    /** The mistakes in the file and the scenarios that fail, each with its line. */
    static JsonObject problems(Folder folder, String path, String text, Texts texts) {
        Map<String, String> unsaved = new HashMap<>(texts.brought());
        folder.require(path);
        if (!Folder.isDevice(path)) {
            throw new RequestException("'" + path + "' is not the name of a device file, which ends in .yaml");
        }
        unsaved.put(path, text);
        try {
            Path copy = Files.createTempDirectory("evoloop-studio");
            try {
                lay(folder, unsaved, copy);
                return new JsonObject().put("problems", found(copy.resolve(path), copy));
            } finally {
                remove(copy);
            }
        } catch (IOException | UncheckedIOException unwritable) {
            throw new RequestException("a device file cannot be read beside its models: " + unwritable.getMessage());
        }
    }

    /** Puts the unsaved texts into {@code copy}, with links to all other files of the folder. */
    private static void lay(Folder folder, Map<String, String> unsaved, Path copy) throws IOException {
        for (String each : folder.files()) {
            if (!unsaved.containsKey(each)) {
                Path link = copy.resolve(each);
                Files.createDirectories(link.getParent());
                Files.createSymbolicLink(link, folder.require(each));
            }
        }
        for (Map.Entry<String, String> each : unsaved.entrySet()) {
            Path file = copy.resolve(each.getKey());
            Files.createDirectories(file.getParent());
            Files.writeString(file, each.getValue());
        }
    }

    private static List<JsonObject> found(Path file, Path copy) throws IOException {
        List<JsonObject> problems = new ArrayList<>();
        try {
            requireInside(file, copy);
            DeviceFile read = DeviceFile.read(file, DeviceProgram.options());
            for (Scenario scenario : read.scenarios()) {
                String failure = scenario.run(read);
                if (!failure.isEmpty()) {
                    problems.add(problem(file + ":" + failure, copy));
                }
            }
        } catch (DeviceFileException | ModelException | ConfigException mistaken) {
            String.valueOf(mistaken.getMessage()).lines().forEach(line -> problems.add(problem(line, copy)));
        }
        return problems;
    }

    /** Models and properties that lie elsewhere are not read. */
    private static void requireInside(Path file, Path copy) throws IOException {
        Problems problems = new Problems(file);
        Section models = Section.parse(Files.readString(file), problems)
                .section("models")
                .orElse(null);
        if (models == null || !problems.isEmpty()) {
            return; // Reading the file says what is wrong.
        }
        for (String key : List.of("original", "new", "properties")) {
            models.text(key)
                    .filter(written ->
                            !file.resolveSibling(written.value()).normalize().startsWith(copy))
                    .ifPresent(written -> problems.at(
                            written,
                            "'" + written + "' is outside of the folder that the studio shows; start it there"));
        }
        problems.throwIfAny();
    }

    private static JsonObject problem(String line, Path copy) {
        Matcher placed = MISTAKE.matcher(line);
        boolean has = placed.matches();
        String message = (has ? placed.group(2) : line).replace(copy + "/", "");
        return new JsonObject()
                .put("line", has ? Integer.parseInt(placed.group(1)) : 1)
                .put("message", message);
    }

    private static void remove(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(each);
            }
        }
    }
}
