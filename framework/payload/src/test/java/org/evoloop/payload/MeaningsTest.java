package org.evoloop.payload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What messages say, in texts and in JSON. */
class MeaningsTest {
    private static final Meanings MODES = Meanings.at("/mode", Map.of("off", "Off", "1", "Low", "true", "On"));

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "{\"mode\":\"off\"}|Off",
                " {\"a\":[{\"mode\":\"1\"}],\"mode\":\"off\"} |Off",
                "{\"mode\": 1}|Low",
                "{\"mode\":true}|On",
                "{\"mode\":\"o\\u0066f\"}|Off",
                "{\"mode\":\"1\",\"mode\":\"off\"}|Off",
            })
    void aValueInJsonHasAMeaning(String message, String meaning) {
        assertThat(MODES.nameOf(message)).contains(meaning);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "off",
                "{",
                "{\"mode\":\"off\"",
                "{\"mode\":\"off\"} and more",
                "{\"mode\":\"off\"}{}",
                "{\"mode\":\"of\"}",
                "{\"mode\":null}",
                "{\"mode\":{\"mode\":\"off\"}}",
                "{\"mode\":[\"off\"]}",
                "[\"off\"]",
                "\"off\"",
                "{\"mode\":1e999}",
                "{mode:off}",
                "\u0000",
            })
    void anythingElseMeansNothing(String message) {
        assertThat(MODES.of(message)).isEmpty();
    }

    @Test
    void aMessageThatIsNestedVeryDeeplyMeansNothing() {
        assertThat(MODES.of("[".repeat(50_000))).isEmpty();
        assertThat(MODES.of("{\"mode\":".repeat(50_000))).isEmpty();
    }

    @Test
    void pointersLeadThroughArraysAndEscapedNames() {
        String message = "{\"a/b\":{\"m~n\":[10,{\"\":\"deep\"}]},\"7\":\"name\"}";
        assertThat(Part.at("/a~1b/m~0n/0").in(message)).contains("10");
        assertThat(Part.at("/a~1b/m~0n/1/").in(message)).contains("deep");
        assertThat(Part.at("/7").in(message)).contains("name");
        assertThat(Part.at("/a~1b/m~0n/2").in(message)).isEmpty();
        assertThat(Part.at("/a~1b").in(message)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"mode", "", "$.mode", "#/mode"})
    void whatIsNoPointerIsRefused(String pointer) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Part.at(pointer))
                .withMessageContaining("write one such as /state");
    }

    @Test
    void theFirstRuleThatAppliesCountsWithItsValues() {
        Meanings said = Meanings.of(Map.of("stop", "stop"))
                .with(Match.matching(Pattern.compile("turn (?<degrees>-?[0-9.]+) ?(?<how>[a-z]+)?")), "turn")
                .with(Match.between(3, 100).at("/power").value("by", Part.at("/who")), "warm")
                .with(Match.any().at("/power"), "hot");
        assertThat(said.of("turn 20.5 fast"))
                .contains(
                        new Meanings.Meaning("turn", Values.of("degrees", 20.5).with("how", "fast")));
        assertThat(said.of("turn 20")).contains(new Meanings.Meaning("turn", Values.of("degrees", 20)));
        assertThat(said.of("please turn 20")).isEmpty();
        assertThat(said.nameOf("stop")).contains("stop");
        assertThat(said.of("{\"power\":3,\"who\":\"me\"}"))
                .contains(new Meanings.Meaning("warm", Values.of("by", "me")));
        assertThat(said.of("{\"power\":99.9}")).contains(new Meanings.Meaning("warm", Values.NONE));
        assertThat(said.nameOf("{\"power\":100}")).contains("hot");
        assertThat(said.nameOf("{\"power\":\"none\"}")).contains("hot");
        assertThat(said.names()).containsExactly("stop", "turn", "warm", "hot");
        assertThat(Meanings.NONE.of("")).isEqualTo(Optional.empty());
    }

    @Test
    void groupsOfATextAreValues() {
        Values values = Match.matching(Pattern.compile("(?<celsius>[0-9.]+) (?<where>\\w+)( (?<none>x))?"))
                .of("21.5 kitchen")
                .orElseThrow();
        assertThat(values).isEqualTo(Values.of("celsius", 21.5).with("where", "kitchen"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "Infinity", "-Infinity", "0x1p3", "1d", "1e999", "1e3", ".5", "1."})
    void whatIsNoPlainNumberIsText(String text) {
        assertThat(Match.matching(Pattern.compile("(?<value>.*)")).of(text)).contains(Values.of("value", text));
        Readings readings = new Readings();
        readings.add("", "level", Part.WHOLE, "mm");
        readings.hear("", text);
        assertThat(readings.known()).containsExactly(Reading.of("level", text));
    }

    @Test
    void aReadingIsTheNewestReportUntilTheDeviceIsGone() {
        Readings readings = new Readings();
        readings.add("t", "room", Part.at("/room"), "°C");
        readings.add("t", "open", Part.at("/open"), "");
        readings.add("u", "battery", Part.WHOLE.group(Pattern.compile("battery ([0-9]+)")), "%");
        readings.hear("t", "{\"room\":26.5,\"open\":true}");
        readings.hear("t", "nonsense");
        readings.hear("u", "battery 30");
        readings.hear("t", "battery 40");
        assertThat(readings.known())
                .containsExactly(
                        Reading.of("battery", 30.0, "%"), Reading.of("open", true), Reading.of("room", 26.5, "°C"));
        readings.hear("t", "{\"room\":\"cold\"}");
        assertThat(readings.known()).contains(Reading.of("room", "cold"));
        readings.clear();
        assertThat(readings.known()).isEmpty();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Part.WHOLE.group(Pattern.compile("battery")))
                .withMessageContaining("has no group");
    }
}
