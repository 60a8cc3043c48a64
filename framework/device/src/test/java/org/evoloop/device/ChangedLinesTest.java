package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Problems;
import org.evoloop.device.file.Section;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The device files of the project whose kinds of connections are known here, with one line changed at a time. */
class ChangedLinesTest {
    private static final Path DEVICES = Path.of(System.getProperty("evoloop.root", "../.."), "devices");
    private static final Pattern KEY = Pattern.compile("^( *)([a-z-]+)(: .*|:)$");

    private static final Pattern WORD = Pattern.compile("\\b\\p{L}");
    private static final Pattern SCENARIOS = Pattern.compile("/scenarios/.*");

    /** One needs a kind of connection that is not here; without models, as the other, any event is right. */
    private static final Set<String> OTHERS = Set.of("roomba.yaml", "kettle.yaml");

    /** What a device or a person may call as they like. */
    private static final Pattern ANY_VALUE = Pattern.compile(
            "/converter|/connections/.*|/device/(send|answer|ask)/.*|/functions/.*/(line|topic|payload|call|body)"
                    + "|/(device/(state|readings)|controller/press)(/.*)?/(json|topic|pattern|unit|attribute|entity)|/guards/.*/reading"
                    + "|/home-assistant/.*/(name|reading)");

    private static final Pattern ANY_KEY =
            Pattern.compile("/(connections|device/state|device/does|device/readings|controller/press|scenarios)/.*"
                    + "|/device/send/.*/data/.*|/home-assistant/.*/modes/.*");

    /** A mapping whose names and values may be anything. */
    private static final Pattern FREE = Pattern.compile("/connections/.*/headers/.*");

    @TempDir
    private Path folder;

    static Stream<Path> files() throws IOException {
        try (Stream<Path> all = Files.walk(DEVICES)) {
            return all
                    .filter(file -> file.toString().endsWith(".yaml")
                            && !OTHERS.contains(file.getFileName().toString()))
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
    void anotherTypeIsRefusedInItsLine(Path file) throws IOException {
        Map<String, String> all = content(file);
        everyLine(file, (lines, at) -> {
            for (String other : List.of(": [1, 2]", ": {a: b}", ":")) {
                String wrong = lines.get(at).replaceFirst(": ?(.*)$", other);
                List<String> refusals = refused(file, changed(lines, at, List.of(wrong)));
                boolean isFree = refusals.isEmpty() && isOnlyAbout(FREE, content(copy()), all);
                if (!wrong.equals(lines.get(at)) && !isFree) {
                    assertThat(refusals).as(wrong).anyMatch(message -> isOf(at, message));
                }
            }
        });
    }

    @ParameterizedTest
    @MethodSource("files")
    void aDoubledLineIsRefusedUnlessItIsAStepOfAScenario(Path file) throws IOException {
        everyLine(file, (lines, at) -> {
            String line = lines.get(at);
            if (!line.strip().startsWith("- ")) {
                assertThat(refused(file, changed(lines, at, List.of(line, line))))
                        .as(line)
                        .anyMatch(message -> isOf(at, message) || isOf(at + 1, message));
            }
        });
    }

    @ParameterizedTest
    @MethodSource("files")
    void aDeletedLineIsRefusedOrChangesNothingElse(Path file) throws IOException {
        Map<String, String> all = content(file);
        everyLine(file, (lines, at) -> {
            if (refused(file, changed(lines, at, List.of())).isEmpty()) {
                Map<String, String> left = content(copy());
                assertThat(isAllOf(left, all) || isOnlyAbout(SCENARIOS, left, all))
                        .as("without " + lines.get(at))
                        .isTrue();
            }
        });
    }

    @ParameterizedTest
    @MethodSource("files")
    void aMisspeltWordIsRefusedUnlessItMayBeAnything(Path file) throws IOException {
        Map<String, String> all = content(file);
        everyLine(file, (lines, at) -> {
            Matcher word = WORD.matcher(lines.get(at));
            while (word.find()) {
                String wrong = new StringBuilder(lines.get(at))
                        .insert(word.start(), 'x')
                        .toString();
                if (refused(file, changed(lines, at, List.of(wrong))).isEmpty()) {
                    Map<String, String> now = content(copy());
                    boolean sameKeys = now.keySet().equals(all.keySet());
                    assertThat(isOnlyAbout(sameKeys ? ANY_VALUE : ANY_KEY, now, all))
                            .as(wrong)
                            .isTrue();
                }
            }
        });
    }

    /** Whether nothing is said that {@code all} does not say, at whichever place of a list. */
    private static boolean isAllOf(Map<String, String> part, Map<String, String> all) {
        List<String> rest = new ArrayList<>(said(all));
        return said(part).stream().allMatch(rest::remove);
    }

    private static List<String> said(Map<String, String> content) {
        return content.entrySet().stream()
                .filter(each -> !each.getValue().isEmpty())
                .map(each -> each.getKey().replaceAll("/[0-9]+(?=/|$)", "/-") + " " + each.getValue())
                .toList();
    }

    /** Whether all that differs is about paths of this kind. */
    private static boolean isOnlyAbout(Pattern paths, Map<String, String> now, Map<String, String> before) {
        return Stream.of(now, before)
                .flatMap(each -> each.keySet().stream())
                .filter(path -> !Objects.equals(now.get(path), before.get(path)))
                .allMatch(path -> paths.matcher(path).matches());
    }

    /** All texts of a file, each by the path to it. */
    private static Map<String, String> content(Path file) {
        Map<String, String> content = new TreeMap<>();
        add("", Section.read(file, new Problems(file)).node(), content);
        return content;
    }

    private static void add(String path, Node node, Map<String, String> content) {
        if (node instanceof Node.Entries entries) {
            entries.entries().forEach((key, value) -> add(path + "/" + key.value(), value, content));
        } else if (node instanceof Node.Items items) {
            for (int at = 0; at < items.items().size(); at++) {
                add(path + "/" + at, items.items().get(at), content);
            }
        } else {
            content.put(path, node.toString());
        }
    }

    /** What is done with one of the lines that say something. */
    private interface Change {
        void of(List<String> lines, int at) throws IOException;
    }

    private static void everyLine(Path file, Change change) throws IOException {
        List<String> lines = Files.readAllLines(file);
        for (int at = 0; at < lines.size(); at++) {
            if (!lines.get(at).isBlank() && !lines.get(at).strip().startsWith("#")) {
                change.of(lines, at);
            }
        }
    }

    private boolean isOf(int at, String message) {
        return message.startsWith(copy() + ":" + (at + 1) + ": ");
    }

    private Path copy() {
        return folder.resolve("changed.yaml");
    }

    private static List<String> changed(List<String> lines, int at, List<String> instead) {
        List<String> changed = new ArrayList<>(lines.subList(0, at));
        changed.addAll(instead);
        changed.addAll(lines.subList(at + 1, lines.size()));
        return changed;
    }

    /** The mistakes, each with its line; none if it is read. */
    private List<String> refused(Path file, List<String> lines) throws IOException {
        Path copy = copy();
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
