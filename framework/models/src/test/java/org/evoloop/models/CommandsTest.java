package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The commands' output for the paper's cleaning robot. */
class CommandsTest {
    private static final String ORIGINAL = Tool.ROBOT + "#original";
    private static final String NEW = Tool.ROBOT + "#new";

    private static String good(String... arguments) {
        Tool run = Tool.run(arguments);
        assertThat(run.err()).isEmpty();
        assertThat(run.status()).isZero();
        return run.out();
    }

    private static JsonNode json(String... arguments) {
        return JsonMapper.shared().readTree(good(arguments));
    }

    @Test
    void showGivesTheJsonThatIsPromised() {
        JsonNode machine =
                json("show", ORIGINAL, "--format", "json").get("machines").get(0);

        assertThat(machine.get("name").asString()).isEqualTo("original");
        assertThat(machine.get("states").toString()).isEqualTo("[\"Off\",\"On\",\"Clean\",\"Spot\"]");
        assertThat(machine.get("events").toString()).isEqualTo("[\"Clean\",\"Spot\",\"endSpot\"]");
        assertThat(machine.get("initial").asString()).isEqualTo("Off");
        assertThat(machine.get("transitions").size()).isEqualTo(5);
        assertThat(machine.get("transitions").get(0).toString())
                .isEqualTo("{\"source\":\"Off\",\"trigger\":\"Clean\",\"guard\":null,\"effect\":null,\"target\":\"On\","
                        + "\"kind\":\"external\"}");
        assertThat(machine.propertyNames())
                .containsExactly(
                        "name",
                        "states",
                        "events",
                        "transitions",
                        "initial",
                        "hierarchy",
                        "regions",
                        "pseudostates",
                        "initialTransitions");
    }

    @Test
    void showListsAllMachinesOfAFile() {
        assertThat(good("show", Tool.ROBOT))
                .contains(
                        "original: 4 states, 3 events, 5 transitions\n",
                        "new: 6 states, 5 events, 8 transitions\n",
                        "  SpotWait\n    timeout -> On\n    Clean -> Spot\n");
    }

    @Test
    void showDrawsForOtherTools() {
        assertThat(good("show", NEW, "--format", "DOT"))
                .startsWith("digraph {")
                .contains("v1 [label=\"Off\"];")
                .contains("[label=\"arriveSpot\"];");
        assertThat(good("show", NEW, "--format", "plantuml"))
                .startsWith("@startuml\n")
                .contains("state \"SpotWait\" as v")
                .contains(" : timeout\n")
                .endsWith("@enduml\n");
    }

    @Test
    void diffShowsKeptAddedReroutedAndRemoved() {
        assertThat(good("diff", ORIGINAL, NEW))
                .contains("states\n  kept      Off, On, Clean, Spot\n  added     Move, SpotWait\n  removed   -\n")
                .contains("  added     Move --arriveSpot--> Spot\n")
                .contains("  rerouted  On --Spot--> Move  (before: On --Spot--> Spot)\n")
                .doesNotContain("  removed   On");
        assertThat(good("diff", NEW, ORIGINAL)).contains("  removed   SpotWait --timeout--> On\n");

        JsonNode difference = json("diff", ORIGINAL, NEW, "--format", "json");
        assertThat(difference.get("machines").toString()).isEqualTo("{\"original\":\"original\",\"new\":\"new\"}");
        assertThat(difference.get("transitions").get("kept").size()).isEqualTo(3);
        assertThat(difference.get("transitions").get("added").size()).isEqualTo(3);
        assertThat(difference.get("transitions").get("rerouted").size()).isEqualTo(2);
        assertThat(difference.get("transitions").get("removed").size()).isZero();
    }

    @Test
    void diffDrawsBothModelsAsOnePicture() {
        String picture = good("diff", ORIGINAL, NEW, "--format", "svg");

        assertThat(picture.split("class=\"state added\"", -1)).hasSize(3);
        assertThat(picture.split("class=\"transition rerouted\"", -1)).hasSize(3);
        assertThat(picture.split("class=\"transition former\"", -1)).hasSize(3);
        assertThat(picture)
                .contains("added by the new model", "where it led before")
                .doesNotContain("removed");
    }

    @Test
    void planExplainsEachTransition() {
        assertThat(good("plan", ORIGINAL, NEW, "--spontaneous", "endSpot").lines())
                .contains("assumed: the converter can send Clean, Spot; the device takes endSpot by itself")
                .contains("(Off, Off)  Off --Clean--> On:  same event Clean")
                .contains("(On, On)  On --Spot--> Move:  new function Move")
                .contains("(Spot, Spot)  Spot --endSpot--> On:  the device has done it")
                .contains(
                        "(Clean, SpotWait)  SpotWait --Clean--> Spot:  path Clean, Spot (Clean --Clean--> On --Spot-->"
                                + " Spot)");
    }

    @Test
    void planShowsWhatFollowsWhenAStepFails() {
        String[] plan = {"plan", ORIGINAL, NEW, "--spontaneous", "endSpot", "--on-failure", "Clean@SpotWait=back"};
        assertThat(good(plan).lines()).contains("    if Spot fails in On: back by Clean");
        plan[6] = "Clean=other-way";
        assertThat(good(plan).lines())
                .contains("    if Clean fails in Off: NO OTHER WAY, the device stays there")
                .contains("    if Spot fails in On: NO OTHER WAY, the device stays there");
        JsonNode path = row(
                json(
                        "plan",
                        ORIGINAL,
                        NEW,
                        "--spontaneous",
                        "endSpot",
                        "--on-failure",
                        "Clean=back",
                        "--format",
                        "json"),
                "SpotWait",
                "Clean");
        assertThat(path.get("onFailure").toString())
                .isEqualTo("[{\"event\":\"Spot\",\"originalState\":\"On\",\"then\":\"back\",\"events\":[\"Clean\"]}]");
    }

    @Test
    void planObeysWhatMustNotBePassed() {
        JsonNode plan =
                json("plan", ORIGINAL, NEW, "--spontaneous", "endSpot", "--do-not-pass", "On", "--format", "json");

        JsonNode impossible = row(plan, "SpotWait", "Clean");
        assertThat(impossible.get("kind").asString()).isEqualTo("impossible");
        assertThat(impossible.get("reason").asString()).contains("Spot").contains("Clean");
        assertThat(plan.get("doNotPass").toString()).isEqualTo("[\"On\"]");
    }

    @Test
    void planShowsPathsWithTheStatesBetween() {
        JsonNode plan = json("plan", ORIGINAL, NEW, "--format", "json");

        JsonNode path = row(plan, "SpotWait", "Clean");
        assertThat(path.get("kind").asString()).isEqualTo("path");
        assertThat(path.get("events").toString()).isEqualTo("[\"Clean\",\"Spot\"]");
        assertThat(path.get("through").toString()).isEqualTo("[{\"state\":\"On\",\"effects\":[]}]");
        assertThat(path.get("marked").asBoolean()).isFalse();
        assertThat(row(plan, "On", "Spot").get("function").asString()).isEqualTo("Move");
    }

    private static JsonNode row(JsonNode plan, String source, String trigger) {
        return plan.get("plan")
                .valueStream()
                .filter(row -> row.get("transition").get("source").asString().equals(source)
                        && row.get("transition").get("trigger").asString().equals(trigger))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void checkFindsANoteInThePapersPairAndEverythingInItsReverse() {
        assertThat(good("check", ORIGINAL, NEW, "--spontaneous", "endSpot"))
                .startsWith("note: swallowed-event: new state Move swallows Clean, Spot")
                .endsWith("\n1 finding\n");

        Tool broken = Tool.run("check", NEW, ORIGINAL, "--format", "json");
        assertThat(broken.status()).isEqualTo(1);
        JsonNode finding =
                JsonMapper.shared().readTree(broken.out()).get("findings").get(0);
        assertThat(finding.get("rule").asString()).isEqualTo("condition-1");
        assertThat(finding.get("severity").asString()).isEqualTo("error");
        assertThat(finding.get("element").asString()).isEqualTo("arriveSpot");
        assertThat(finding.get("place").asString()).matches(".*cleaning-robot\\.xml, line \\d+, id .*");
        assertThat(finding.get("remedy").asString()).isNotEmpty();
    }

    @Test
    void checkReportsOnceAnEventThatIsNeitherSentNorDeclared() {
        Tool undeclared = Tool.run("check", ORIGINAL, NEW, "--sendable", "Clean,Spot");
        assertThat(undeclared.status()).isEqualTo(1);
        assertThat(undeclared.out())
                .contains("error", "unsendable-event: event endSpot of the original model")
                .doesNotContain("no-path", "degradation");
        assertThat(good("check", ORIGINAL, NEW, "--sendable", "Clean,Spot", "--spontaneous", "endSpot"))
                .startsWith("note: swallowed-event")
                .endsWith("\n1 finding\n");

        String plan = good("plan", ORIGINAL, NEW, "--sendable", "Clean,Spot");
        assertThat(plan)
                .contains(
                        "(Spot, Spot)  Spot --endSpot--> On:  IMPOSSIBLE: event endSpot is the device's, but can neither");
    }

    @Test
    void checkSeesWhatButtonsOfTheDevicesOwnCanDo() {
        assertThat(Tool.run("check", ORIGINAL, NEW, "--sendable", "Clean,Spot", "--spontaneous", "Clean,Spot,endSpot")
                        .out())
                .contains("hazard");
    }

    @Test
    void checkUsesTheConvertersOptions() {
        Tool unbound =
                Tool.run("check", ORIGINAL, NEW, "--functions", "Move", "--raised", "Clean,Spot,endSpot,timeout");

        assertThat(unbound.status()).isEqualTo(1);
        assertThat(unbound.out())
                .contains("no-function: new state SpotWait", "unraised-event: nobody raises event arriveSpot");
    }

    @Test
    void checkReckonsWithWhatOnlyTheCodeDeclares(@TempDir Path folder) throws IOException {
        Path properties =
                Files.writeString(folder.resolve("p.txt"), "Still: always (function Move implies device On)\n");
        String[] check = {"check", ORIGINAL, NEW, "--spontaneous", "endSpot", "--properties", properties.toString()};

        assertThat(Tool.run(check).out()).doesNotContain("unknown-property");
        String[] sending = Arrays.copyOf(check, check.length + 2);
        sending[check.length] = "--sends";
        sending[check.length + 1] = "Move=Clean,Move=Spot";
        assertThat(Tool.run(sending).out())
                .contains("unknown-property: 'Still'", "the function of Move may send events");
    }

    /** A guard may contain commas, which also separate the guards in an option's list. */
    @Test
    void namesWithCommasAreFoundInLists() {
        Set<String> known = Set.of("a", "max(a, b) > 1", "c");

        assertThat(KnownNames.resolve("--guards", List.of("c", "max(a", " b) > 1", " a "), known, "guard"))
                .containsExactly("c", "max(a, b) > 1", "a");
        assertThat(KnownNames.resolve("--guards", List.of(""), known, "guard")).isEmpty();
        assertThatThrownBy(() -> KnownNames.resolve("--guards", List.of("max(a", "c", "b"), Set.of("c"), "guard"))
                .hasMessage("--guards: there is no guard named max(a, b; choose from: c");
    }

    @Test
    void flattenIsATable() {
        assertThat(good("flatten", NEW).lines())
                .startsWith("new (6 states, 5 events, 8 transitions), starts in Off")
                .contains("SpotWait  timeout                     On");
    }

    @Test
    void flattenSurvivesLineBreaks(@TempDir Path directory) throws IOException {
        Path file = directory.resolve("lines.scxml");
        Files.writeString(file, """
                <scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' initial='A&#x85;1'>
                  <state id='A&#x85;1'><transition event='e' cond='x&#10;and y' target='B'><script>one();
                two();</script></transition></state>
                  <state id='B'><invoke src='three&#10;();'/></state>
                </scxml>""");

        assertThat(Tool.run("flatten", file.toString()).out().lines())
                .containsExactly(
                        "lines (2 states, 1 events, 1 transitions), starts in A?1",
                        "B does invoke(src='three?();')",
                        "state  event  guard    effects        next state",
                        "A?1    e      x?and y  one();?two();  B");
        assertThat(Tool.run("show", file.toString()).out().lines())
                .contains("  A?1", "    e [x?and y] / one();?two(); -> B");
        Tool xmi = Tool.run("flatten", file.toString(), "--format", "xmi");
        assertThat(xmi.err()).contains("note: the line breaks in 'one();?two();' become spaces");
        Files.writeString(directory.resolve("flat.xml"), xmi.out());
        assertThat(Tool.run("flatten", directory.resolve("flat.xml").toString()).out())
                .contains("A 1    e      x and y  one(); two();  B");
    }

    @Test
    void aFileOfSeveralMachinesIsShownAsMarkdownThatReadsBack(@TempDir Path directory) throws IOException {
        Path file = Files.writeString(directory.resolve("robot.md"), good("show", Tool.ROBOT, "--format", "mermaid"));

        assertThat(file).content().startsWith("```mermaid\n---\ntitle: original\n---\nstateDiagram-v2\n");
        assertThat(good("diff", NEW, file + "#new")).doesNotContain("added:", "removed:");
        assertSameTable(file + "#new");
    }

    /** In any order: in a text, a state comes where it is first named. */
    private static void assertSameTable(String reference) {
        assertThat(good("flatten", reference).lines())
                .containsExactlyInAnyOrderElementsOf(
                        good("flatten", NEW).lines().toList());
    }

    @Test
    void whatFlattenWritesReadsBack(@TempDir Path directory) throws IOException {
        for (String format : List.of("mermaid", "scxml")) {
            Path file = Files.writeString(directory.resolve("new." + format), good("flatten", NEW, "--format", format));

            assertSameTable(file.toString());
        }
    }

    @Test
    void anScxmlDocumentHoldsOneMachine() {
        Tool several = Tool.run("show", Tool.ROBOT, "--format", "scxml");

        assertThat(several.status()).isEqualTo(2);
        assertThat(several.err()).contains("an SCXML document holds one machine; name one of", "#original", "#new");
        assertThat(good("show", NEW, "--format", "scxml")).startsWith("<?xml").contains("name=\"new\"");
    }
}
