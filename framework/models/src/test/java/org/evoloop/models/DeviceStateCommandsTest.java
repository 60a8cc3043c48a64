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
