package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.journal.Journal;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.testkit.SimulatedDevice;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** A lamp's converter writes a journal, also while it is being read. */
class JournalCommandTest {
    @TempDir
    private Path folder;

    private ConverterHarness converter;

    @BeforeEach
    void keepAJournal() {
        ModelFile lamp = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "light-bulb.xml"));
        StateMachine original = lamp.pick("original");
        StateKnowledge knowledge = new StateKnowledge(new ModelPair(original, lamp.pick("new"))) {
            @Override
            protected void registerNewFunctions() {
                function("wait", NewFunction.none());
                function("incandescentOn", NewFunction.none());
            }
        };
        converter = ConverterHarness.of(knowledge)
                .with(SimulatedDevice.of(original).build())
                .with(Journal.in(folder.resolve("journal")))
                .start()
                .press("switch", Values.of("by", "a \"visitor\""));
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private String directory() {
        return folder.resolve("journal").toString();
    }

    @Test
    void replayShowsWhereOtherModelsWouldHaveDecidedDifferently() throws Exception {
        String lamp = Path.of(System.getProperty("evoloop.root"), "models", "light-bulb.xml")
                .toString();
        Tool same =
                Tool.run("journal", "replay", directory(), "--original", lamp + "#original", "--new", lamp + "#new");
        assertThat(same.err()).isEmpty();
        assertThat(same.status()).isZero();
        assertThat(same.out()).isEqualTo("1 events, 0 decided differently; 2 properties, 0 broken, 0 open\n");

        Path other = party();
        String[] replay = {"journal", "replay", directory(), "--original", lamp + "#original", "--new", other + "#other"
        };
        assertThat(Tool.run(replay).out())
                .contains("switch (controller, by=a \"visitor\")\n")
                .contains("  then  (off, off) -> (on, on), sends switch: existing-function\n")
                .contains("  now   (off, off) -> (off, party): new-function\n")
                .endsWith("1 events, 1 decided differently\n");
        String[] json = Arrays.copyOf(replay, replay.length + 2);
        json[replay.length] = "--format";
        json[replay.length + 1] = "json";
        JsonNode parsed = new ObjectMapper().readTree(Tool.run(json).out());
        JsonNode difference = parsed.path("differences").get(0);
        assertThat(difference.path("then").path("sent").get(0).asString()).isEqualTo("switch");
        assertThat(difference.path("now").path("after").path("new").asString()).isEqualTo("party");

        assertThat(Tool.run(
                        "journal",
                        "replay",
                        folder.toString(),
                        "--original",
                        lamp + "#original",
                        "--new",
                        lamp + "#new"))
                .satisfies(none -> assertThat(none.status()).isEqualTo(2))
                .satisfies(none -> assertThat(none.err()).contains("is not a journal"));
    }

    private Path party() throws IOException {
        return Files.writeString(folder.resolve("other.scxml"), """
                        <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" initial="off" name="other">
                          <state id="off"><transition event="switch" target="party"/></state>
                          <state id="on"><transition event="switch" target="off"/></state>
                          <state id="party"><transition event="switch" target="on"/></state>
                        </scxml>
                        """);
    }

    private Tool replayParty(String... options) throws IOException {
        String lamp = Path.of(System.getProperty("evoloop.root"), "models", "light-bulb.xml")
                .toString();
        List<String> arguments = new ArrayList<>(List.of("journal", "replay", directory()));
        arguments.addAll(List.of("--original", lamp + "#original", "--new", party() + "#other"));
        arguments.addAll(List.of(options));
        return Tool.run(arguments.toArray(String[]::new));
    }

    @Test
    void aPropertyThatTheEventsBreakGivesTheStatusAndIsReportedWithItsEvent() throws IOException {
        Path beside = Files.writeString(
                folder.resolve("other.properties.txt"),
                "No party: never party\nIt ends: always (party implies eventually on)\nIt can end: always can on\n");
        Tool text = replayParty();
        assertThat(text.status()).isEqualTo(1);
        assertThat(text.err()).isEmpty();
        assertThat(text.out())
                .containsPattern("broken: 'No party' \\(.*other.properties.txt, line 1\\) at \\d{4}-.*, by switch"
                        + " \\(controller, by=a \"visitor\"\\), in \\(off, party\\)\n")
                .contains("open: 'It ends' (" + beside + ", line 2)")
                .endsWith("1 events, 1 decided differently; 3 properties, 1 broken, 1 open\n");

        JsonNode properties = new ObjectMapper()
                .readTree(replayParty("--format", "json").out())
                .path("properties");
        assertThat(properties.path(0).path("standing").asString()).isEqualTo("broken");
        assertThat(properties.path(0).path("event").asString()).isEqualTo("switch");
        assertThat(properties.path(0).path("at").path("new").asString()).isEqualTo("party");
        assertThat(properties.path(1).path("standing").asString()).isEqualTo("open");
        assertThat(properties.path(2).path("standing").asString()).isEqualTo("kept");
        assertThat(properties.path(2).path("event").isNull()).isTrue();

        Tool picture = replayParty("--format", "svg");
        assertThat(picture.status()).isEqualTo(1);
        assertThat(picture.out())
                .startsWith("<svg")
                .contains(
                        "breaks: No party",
                        "switch \u2192 party, was \u2192 on",
                        "a property is broken",
                        "breaks 'No party' in (off, party)",
                        "(off, off) -&gt; (off, party): new-function");
    }

    @Test
    void propertiesMayBeNamedAndMustBeUnderstood() throws IOException {
        Path named = Files.writeString(folder.resolve("mine.txt"), "never event switch\n");
        assertThat(replayParty("--properties", named.toString())).satisfies(broken -> {
            assertThat(broken.status()).isEqualTo(1);
            assertThat(broken.out()).contains("broken: 'never event switch' (" + named + ", line 1)");
        });
        Files.writeString(named, "off: on\nnever Party\n");
        assertThat(replayParty("--properties", named.toString())).satisfies(wrong -> {
            assertThat(wrong.status()).isEqualTo(2);
            assertThat(wrong.out()).isEmpty();
            assertThat(wrong.err())
                    .isEqualTo("error: " + named
                            + ", line 2: there is no state of the new model named Party; there are off, on, party\n");
        });
        assertThat(replayParty("--properties", folder.resolve("none").toString())
                        .err())
                .isEqualTo("error: " + folder.resolve("none") + ": does not exist; correct the path\n");
    }

    @Test
    void showPrintsARecordALine() {
        Tool all = Tool.run("journal", "show", directory());
        assertThat(all.status()).isZero();
        assertThat(all.out().lines())
                .allMatch(line -> line.matches("\\d{4}-\\d\\d-\\d\\d [\\d:.]+ +\\d+\\.\\d{6}  [a-z-]+ .* at \\(.*"))
                .anyMatch(line -> line.contains("observed   switch (controller, by=a \"visitor\")  at (off, off)"))
                .anyMatch(line -> line.contains("sent       #1  at (on, on)  | switch handled"));
        assertThat(Tool.run("journal", "show", directory(), "--last", "1").out())
                .isEqualTo(all.out().lines().reduce((before, last) -> last).orElseThrow() + "\n");
        assertThat(Tool.run("journal", "show", directory(), "--from", "2100-01-01T00:00")
                        .out())
                .isEmpty();
        assertThat(Tool.run("journal", "show", directory(), "--to", "2100-01-01T00:00:00Z")
                        .out())
                .isEqualTo(all.out());
        assertThat(Tool.run("journal", "show", directory(), "--json").out().lines())
                .hasSize((int) all.out().lines().count())
                .anyMatch(line -> line.contains("\"event\":\"switch\",\"source\":\"controller\""));
    }

    @Test
    void exportsHoldEveryRecord() throws Exception {
        long records = Tool.run("journal", "show", directory()).out().lines().count();
        Path json = folder.resolve("out.json");
        assertThat(Tool.run("journal", "export", directory(), "--format", "json", "--output", json.toString()))
                .isEqualTo(new Tool(0, "", ""));
        JsonNode document = new ObjectMapper().readTree(Files.readString(json));
        assertThat(document.get("records").size()).isEqualTo((int) records);
        assertThat(document.get("segments").get(0).get("original").asString()).contains("original");
        Path table = folder.resolve("out.db");
        assertThat(Tool.run("journal", "export", directory(), "--format", "sqlite", "--output", table.toString()))
                .isEqualTo(new Tool(0, "", ""));
        try (var database = DriverManager.getConnection("jdbc:sqlite:" + table);
                ResultSet row = database.createStatement()
                        .executeQuery(
                                "SELECT count(*), max(event_values) FROM record WHERE event IS NULL OR event = 'switch'")) {
            assertThat(row.getLong(1)).isEqualTo(records);
            assertThat(row.getString(2)).isEqualTo("{\"by\":\"a \\\"visitor\\\"\"}");
        }
        Path memory = Path.of(":memory:");
        try {
            assertThat(Tool.run("journal", "export", directory(), "--format", "sqlite", "--output", memory.toString()))
                    .isEqualTo(new Tool(0, "", ""));
            assertThat(memory).isNotEmptyFile();
        } finally {
            Files.deleteIfExists(memory);
        }
        Tool again = Tool.run("journal", "export", directory(), "--format", "sqlite", "--output", table.toString());
        assertThat(again.status()).isEqualTo(2);
        assertThat(again.err()).isEqualTo("error: " + table + " exists; delete it, or name another file\n");
    }

    @Test
    void verifyDistinguishesDamagedSoundAndForeignFiles() throws Exception {
        Tool sound = Tool.run("journal", "verify", directory());
        assertThat(sound.status()).isZero();
        assertThat(sound.out())
                .endsWith(directory() + " is sound: "
                        + Tool.run("journal", "show", directory()).out().lines().count() + " records\n");
        Path copy = Files.createDirectory(folder.resolve("copy"));
        byte[] bytes = Files.readAllBytes(folder.resolve("journal/0000000001.journal"));
        bytes[200] ^= 4;
        Files.write(copy.resolve("0000000001.journal"), bytes);
        for (String command : new String[] {"verify", "show"}) {
            Tool damaged = Tool.run("journal", command, copy.toString());
            assertThat(damaged.status()).isEqualTo(1);
            assertThat(damaged.err())
                    .matches(
                            "error: .*/0000000001.journal, byte 104, record 1: its checksum is wrong. The journal is damaged;"
                                    + " restore 0000000001.journal from a copy; .*\n");
        }
        Path half = folder.resolve("half.db");
        assertThat(Tool.run("journal", "export", copy.toString(), "--format", "sqlite", "--output", half.toString())
                        .status())
                .isEqualTo(1);
        assertThat(half).as("no output file is left for a damaged journal").doesNotExist();
        for (String format : new String[] {"json", "sqlite"}) {
            Path nowhere = folder.resolve("no/such/folder");
            Tool unwritten =
                    Tool.run("journal", "export", directory(), "--format", format, "--output", nowhere.toString());
            assertThat(unwritten.status()).isEqualTo(2);
            assertThat(unwritten.err())
                    .isEqualTo("error: " + nowhere + " cannot be written: " + nowhere.getParent()
                            + " is not a directory\n");
        }
        Path none = Files.createDirectory(folder.resolve("none"));
        Tool wrong = Tool.run("journal", "verify", none.toString());
        assertThat(wrong.status()).isEqualTo(2);
        assertThat(wrong.err()).startsWith("error: " + none + " is not a journal");
        assertThat(Tool.run("journal").status()).isEqualTo(2);
        assertThat(Tool.run("journal", "show", directory(), "--last", "0").err())
                .isEqualTo("error: --last is 0; it must be at least 1\n");
    }
}
