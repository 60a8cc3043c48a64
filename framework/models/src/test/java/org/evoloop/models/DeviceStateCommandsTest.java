package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.json.JsonMapper;

/** What the commands say about new states that use the device: a shutter with one button gets a state half-way. */
class DeviceStateCommandsTest {
    @TempDir
    private Path directory;

    private String original = "";
    private String evolved = "";

    /** The states that the device has, too. */
    private static final String SHUTTER = """
            <state id="Down"><transition event="tap" target="Rising"/>%s</state>
            <state id="Rising">
              <transition event="tap" target="HalfUp"/>
              <transition event="top" target="Up" ev:spontaneous="true"/>
            </state>
            <state id="HalfUp"><transition event="tap" target="Falling"/></state>
            <state id="Up"><transition event="tap" target="Falling"/></state>
            <state id="Falling">
              <transition event="tap" target="HalfDown"/>
              <transition event="bottom" target="Down" ev:spontaneous="true"/>
            </state>
            <state id="HalfDown"><transition event="tap" target="Rising"/></state>
            """;

    private String write(String name, String fromDown, String more) throws IOException {
        Path file = directory.resolve(name + ".scxml");
        Files.writeString(
                file,
                "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\" name=\"" + name
                        + "\" initial=\"Down\" xmlns:ev=\"urn:evoloop\">\n" + SHUTTER.formatted(fromDown) + more
                        + "</scxml>\n");
        return file.toString();
    }

    /** @param airing attributes of the new state, which the device state makes half-way open */
    private String evolved(String name, String airing) throws IOException {
        return write(name, "<transition event=\"air\" target=\"ToAir\"/>", """
                <state id="ToAir" ev:device="Rising">
                  <transition event="after 2 s" target="Airing"/>
                  <transition event="tap" target="HalfUp"/>
                  <transition event="top" target="Up"/>
                </state>
                <state id="Airing" %s>
                  <transition event="tap" target="Falling"/>
                  <transition event="air" target="Falling"/>
                </state>
                """.formatted(airing));
    }

    @BeforeEach
    void write() throws IOException {
        original = write("original", "", "");
        evolved = evolved("airing", "ev:device=\"HalfUp\" ev:sends=\"tap\"");
    }

    private static String good(String... arguments) {
        Tool tool = Tool.run(arguments);
        assertThat(tool.status()).as(tool.err()).isZero();
        return tool.out();
    }

    @Test
    void showsThemInEveryFormat() {
        assertThat(good("show", evolved)).contains("  Airing\n    «device HalfUp» «sends tap»\n");
        for (String format : new String[] {"dot", "plantuml", "svg"}) {
            assertThat(good("show", evolved, "--format", format))
                    .as(format)
                    .contains("«device HalfUp» «sends tap»", "«device Rising»");
        }
        assertThat(JsonMapper.shared()
                        .readTree(good("show", evolved, "--format", "json"))
                        .at("/machines/0/hierarchy")
                        .toString())
                .contains("\"state\":\"Airing\"", "\"device\":\"HalfUp\",\"sends\":[\"tap\"]")
                .contains("\"device\":null,\"sends\":[]");
    }

    @Test
    void checkProvesWhatTheDeviceStatePromises() throws IOException {
        Path properties = directory.resolve("air.txt");
        Files.writeString(properties, """
                Half-way open: always Airing implies device HalfUp
                On its way: always ToAir implies device Rising
                It can be closed: always can device Down
                """);
        String quiet = evolved("quiet", "ev:device=\"HalfUp\"");
        assertThat(good("check", original, quiet, "--properties", properties.toString()))
                .startsWith(
                        "note: timer-or-device: in ToAir, after 2 s leads to Airing, but top, which the device raises"
                                + " in Rising by itself, leads to Up")
                .endsWith("1 finding\n");

        Files.writeString(properties, "Shut: always Airing implies device Down\n");
        Tool shut = Tool.run("check", original, quiet, "--properties", properties.toString());
        assertThat(shut.status()).isEqualTo(1);
        assertThat(shut.out())
                .contains("error: property: 'Shut'")
                .contains("way:  (Down, Down) --air--> (Rising, ToAir) --after 2 s--> (HalfUp, Airing)\n");
    }

    @Test
    void checkRefusesWhatCannotBe() throws IOException {
        assertThat(Tool.run("check", original, evolved("misspelt", "ev:device=\"HalfUpp\""))
                        .out())
                .startsWith("error: device-state: the device state of Airing, HalfUpp, is not a state of the original"
                        + " model\n")
                .contains("did you mean HalfUp?");
        assertThat(Tool.run("check", original, evolved).out())
                .contains("error: declared-send: the function of Airing sends tap, which takes the device out of its"
                        + " device state to Falling");
        String nowhere = write(
                "nowhere",
                "<transition event=\"air\" target=\"Airing\"/>",
                "<state id=\"Airing\" ev:device=\"Up\"><transition event=\"tap\" target=\"Falling\"/></state>");
        assertThat(Tool.run("check", original, nowhere).out())
                .startsWith("error: no-path: in (Down, Down) event air leads to Airing, where the device must be in Up")
                .contains("fix:  draw a new state with device state Rising and a transition on top\n");
    }

    @Test
    void planShowsThePathToADeviceState() {
        assertThat(good("plan", original, evolved))
                .contains(
                        "Down --air--> ToAir:  path tap (Down --tap--> Rising), new function ToAir, the device in Rising\n")
                .contains(
                        "ToAir --after 2 s--> Airing:  path tap (Rising --tap--> HalfUp), new function Airing, the device"
                                + " in HalfUp\n");
        assertThat(good("plan", original, evolved, "--format", "json")).contains("\"function\" : \"Airing\"");
        assertThat(good("plan", original, evolved, "--bypass"))
                .contains("(Rising, ToAir)  the function of ToAir does not run, no timer runs for after 2 s: the device"
                        + " stays in Rising until top\n")
                .contains("(HalfUp, Airing)  the function of Airing does not run: the device stays in HalfUp\n");
    }

    /** The example in the documentation. */
    @Test
    void theAirConditionerBoosts() {
        Path folder = Path.of(System.getProperty("evoloop.root"), "models", "air-conditioner");
        String before = folder.resolve("original.scxml").toString();
        String after = folder.resolve("new.scxml").toString();

        assertThat(good("check", before, after)).isEqualTo("nothing found\n");
        assertThat(good("plan", before, after))
                .contains(
                        "(Dry, Dry)  Dry --boost--> Boost [history Dry]:  path turbo (Dry --turbo--> Turbo), new function"
                                + " Boost [history Dry], the device in Turbo\n");
        assertThat(good("migrate", after, after, "--original", before))
                .contains(
                        "(Turbo, Boost [history Dry]): timer tm(10min) kept, function Boost kept; Boost [history Dry], the"
                                + " device in Turbo\n")
                .contains("(Dry, Dry)  maps to (Dry, Dry)\n");
    }

    @Test
    void flattenKeepsThem() throws IOException {
        assertThat(good("flatten", evolved))
                .contains("ToAir has the device in Rising\nAiring has the device in HalfUp\nAiring may send tap\n");
        Path flat = directory.resolve("flat.xml");
        Files.writeString(flat, good("flatten", evolved, "--format", "xmi"));

        assertThat(good("flatten", flat.toString())).isEqualTo(good("flatten", evolved));
        assertThat(good("diff", evolved, flat.toString())).doesNotContain("device");
    }

    @Test
    void diffShowsWhatIsNewAndWhatHasChanged() throws IOException {
        assertThat(good("diff", original, evolved))
                .contains(
                        "device\n  added     ToAir «device Rising»\n  added     Airing «device HalfUp» «sends tap»\n");
        String other = evolved("other", "ev:device=\"HalfDown\"");
        assertThat(good("diff", evolved, other))
                .contains("device\n  changed   Airing «device HalfDown»  (before: «device HalfUp» «sends tap»)\n");
        assertThat(good("diff", evolved, evolved("without", "")))
                .contains("device\n  removed   Airing «device HalfUp» «sends tap»\n");
        assertThat(good("diff", evolved, other, "--format", "svg")).contains("class=\"state rerouted\"");
        assertThat(JsonMapper.shared()
                        .readTree(good("diff", evolved, other, "--format", "json"))
                        .get("device")
                        .toString())
                .isEqualTo("[{\"state\":\"Airing\",\"before\":{\"state\":\"HalfUp\",\"sends\":[\"tap\"]},"
                        + "\"after\":{\"state\":\"HalfDown\",\"sends\":[]}}]");
    }
}
