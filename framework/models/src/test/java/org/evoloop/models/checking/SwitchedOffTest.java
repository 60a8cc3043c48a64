package org.evoloop.models.checking;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.models.Tool;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Rules that are switched off for one element, and findings about the same element of the drawing. */
class SwitchedOffTest {
    private static final String LAMP = """
            <state id="Off"><transition event="press" target="On"/></state>
            <state id="On"><transition event="press" target="Off"/>
            """;

    @TempDir
    private Path directory;

    private Path original;
    private Path evolved;

    @BeforeEach
    void twoLamps() throws IOException {
        original = scxml("original.scxml", LAMP + "</state>");
        evolved = scxml("new.scxml", LAMP + """
                <transition event="warm" target="Warm"/><transition event="hot" target="Hot"/></state>
                <state id="Warm"/><state id="Hot"/>
                """);
    }

    private Path scxml(String name, String states) throws IOException {
        return Files.writeString(
                directory.resolve(name),
                "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' initial='Off'>" + states + "</scxml>");
    }

    private Tool check(String properties, String... options) throws IOException {
        Files.writeString(directory.resolve("new.properties.txt"), properties);
        String[] arguments = new String[3 + options.length];
        arguments[0] = "check";
        arguments[1] = original.toString();
        arguments[2] = evolved.toString();
        System.arraycopy(options, 0, arguments, 3, options.length);
        return Tool.run(arguments);
    }

    @Test
    void aRuleIsSwitchedOffForOneElementWithAReason() throws IOException {
        Tool one = check("off trap-state Warm: it cools down\n    by itself\nAlways: can On or Warm or Hot\n");

        assertThat(one.err()).isEmpty();
        assertThat(one.status()).isEqualTo(1);
        assertThat(one.out())
                .contains("warning: trap-state: state Hot of the new model cannot be left\n")
                .contains(
                        "off: trap-state: state Warm of the new model cannot be left\n  why:  it cools down by itself (")
                .contains("new.properties.txt, line 1)\n")
                .endsWith("1 finding, 1 switched off\n");

        Tool both = check("off trap-state Warm: it cools down\noff trap-state \"Hot\": so does it\n");
        assertThat(both.status()).isZero();
        assertThat(both.out()).endsWith("nothing found, 2 switched off\n");
    }

    @Test
    void programsGetWhatIsSwitchedOff() throws IOException {
        JsonNode json = JsonMapper.shared()
                .readTree(check("off trap-state Warm: it cools down\n", "--format", "json")
                        .out());

        assertThat(json.get("findings").size()).isEqualTo(1);
        assertThat(json.get("switchedOff").size()).isEqualTo(1);
        assertThat(json.get("switchedOff").get(0).get("element").asString()).isEqualTo("Warm");
        assertThat(json.get("switchedOff").get(0).get("reason").asString()).isEqualTo("it cools down");
    }

    @Test
    void whatIsWrittenWronglyIsRefusedWithItsLine() throws IOException {
        Tool wrong = check("""
                off trap-state Cold: there is none
                off trap-state Warm
                off trap-states Warm: no such rule
                off trap-state: nothing named
                off property Warm: not so
                """);

        assertThat(wrong.status()).isEqualTo(2);
        assertThat(wrong.out()).isEmpty();
        assertThat(wrong.err())
                .contains("new.properties.txt, line 1: no model has 'Cold'")
                .contains("line 2: say why trap-state does not matter for Warm")
                .contains("line 3: there is no rule trap-states; choose from: condition-1, ")
                .contains("line 4: no model has an element without a name")
                .contains("line 5: a property is switched off by removing it");
    }

    @Test
    void aSwitchThatIsOfNoUseIsReported() throws IOException {
        Tool useless = check("off trap-state On: it was one\noff unraised-event warm: the sun does\n");

        assertThat(useless.err())
                .startsWith("note: ")
                .contains("line 1: trap-state does not find anything at On; remove the line")
                .doesNotContain("unraised-event");
    }

    /** A transition from a composite state becomes one from each substate in the flat machine. */
    @Test
    void whatIsOneInTheDrawingIsOneFinding() throws IOException {
        StringBuilder inner = new StringBuilder("<state id='All'><initial><transition target='S0'/></initial>");
        for (int i = 0; i < 13; i++) {
            inner.append("<state id='S" + i + "'><transition event='next' target='S" + (i + 1) % 13 + "'/></state>");
        }
        original = scxml(
                "ring.scxml",
                "<state id='Off'><transition event='next' target='S0'/></state>" + inner
                        + "<transition event='stop' cond='a' target='Off'/></state>");
        evolved = scxml(
                "new.scxml",
                "<state id='Off'><transition event='next' target='S0'/></state>" + inner
                        + "<transition event='stop' cond='a' target='Off'/><transition event='stop' cond='b' target='S2'/></state>");
        Tool json = check("", "--format", "json");
        assertThat(json.err()).isEmpty();
        JsonNode findings = JsonMapper.shared().readTree(json.out()).get("findings");

        assertThat(findings.valueStream())
                .extracting(finding -> finding.get("rule").asString())
                .containsExactly("guard-overlap");
    }
}
