package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.evoloop.device.file.DeviceFileException;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The device files of the project whose kinds of connections are known here, with one line changed at a time. */
class ChangedLinesTest {
    private static final Path DEVICES = Path.of(System.getProperty("evoloop.root", "../.."), "devices");
    private static final Pattern KEY = Pattern.compile("^( *)([a-z-]+)(: .*|:)$");

    @TempDir
    private Path folder;

    static Stream<Path> files() throws IOException {
        try (Stream<Path> all = Files.walk(DEVICES)) {
            return all
                    .filter(file -> file.toString().endsWith(".yaml") && !file.endsWith("roomba.yaml"))
                    .sorted()
                    .toList()
                    .stream();
        }
    }

    @ParameterizedTest
    @MethodSource("files")
    void aMisspeltKeyIsRefusedInItsLine(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        for (int at = 0; at < lines.size(); at++) {
            var key = KEY.matcher(lines.get(at));
            // The keys that are names of the file's own are not known anyway.
            if (key.matches() && key.group(1).length() <= 2 && !isNamed(lines, at)) {
                String wrong = key.group(1) + key.group(2) + "x" + key.group(3);
                assertThat(refused(file, changed(lines, at, List.of(wrong))))
                        .as(wrong)
                        .anyMatch(message -> message.contains("'" + key.group(2) + "x' is not known")
                                || message.contains("needs " + key.group(2)));
            }
        }
    }

    private static boolean isNamed(List<String> lines, int at) {
        for (int before = at; before >= 0; before--) {
            if (!lines.get(before).startsWith(" ") && !lines.get(before).isBlank()) {
                return before != at && lines.get(before).matches("(connections|functions|guards|effects|scenarios):.*");
            }
        }
        return false;
    }

    @ParameterizedTest
    @MethodSource("files")
    void whateverHappensToALineEachMistakeHasAPlace(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        List<UnaryOperator<String>> changes = List.of(
                line -> line.replaceFirst(": ?(.*)$", ": [1, 2]"),
                line -> line.replaceFirst(": ?(.*)$", ": {a: b}"),
                line -> line.replaceFirst(": ?(.*)$", ":"),
                line -> line.replaceFirst("[a-z]", ""),
                line -> " " + line,
                line -> line + " }");
        for (int at = 0; at < lines.size(); at++) {
            refused(file, changed(lines, at, List.of()));
            refused(file, changed(lines, at, List.of(lines.get(at), lines.get(at))));
            for (UnaryOperator<String> change : changes) {
                refused(file, changed(lines, at, List.of(change.apply(lines.get(at)))));
            }
        }
    }

    private static List<String> changed(List<String> lines, int at, List<String> instead) {
        List<String> changed = new ArrayList<>(lines.subList(0, at));
        changed.addAll(instead);
        changed.addAll(lines.subList(at + 1, lines.size()));
        return changed;
    }

    /** The mistakes, each with its line; none if it is read. */
    private List<String> refused(Path file, List<String> lines) throws IOException {
        Path copy = folder.resolve("changed.yaml");
        Files.write(copy, lines);
        Files.writeString(folder.resolve("README.md"), Files.readString(file.resolveSibling("README.md")));
        try {
            DeviceFile.read(copy, DeviceProgram.options());
            return List.of();
        } catch (DeviceFileException refused) {
            List<String> messages = refused.getMessage().lines().toList();
            assertThat(messages.get(0)).matches(Pattern.quote(copy.toString()) + ":[0-9]+: .+");
            return messages;
        }
    }
}
