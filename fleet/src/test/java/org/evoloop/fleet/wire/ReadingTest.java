package org.evoloop.fleet.wire;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.evoloop.evolution.Occurrence;
import org.evoloop.payload.JsonRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

class ReadingTest {
    /** Reads a record, to which a schema is added if it has none. */
    private static Reading reading(String record) {
        return readingOf(
                record.startsWith("{\"") && !record.contains("schema")
                        ? "{\"schema\":1," + record.substring(1)
                        : record);
    }

    private static Reading readingOf(String record) {
        return Reading.of(record.getBytes(StandardCharsets.UTF_8));
    }

    @ParameterizedTest
    @ValueSource(strings = {"{}", "{\"event\":\"e\"}"})
    void aRecordWithoutASchemaIsMalformed(String record) {
        assertThatThrownBy(() -> readingOf(record))
                .isInstanceOfSatisfying(
                        Refusal.class, refusal -> assertThat(refusal.reason()).isEqualTo(Refusal.Reason.MALFORMED))
                .hasMessage("it has no schema; write \"schema\":1");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"atMillis\":1,\"event\":\"?\"}",
                "{\"atMillis\":1,\"kind\":\"asked\",\"event\":\"?\"}",
                "{\"atMillis\":1,\"kind\":\"found\",\"state\":\"?\"}",
                "{\"atMillis\":1,\"event\":\"e\",\"holding\":[\"?\"]}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":{\"?\":1}}"
            })
    void anOversizedNameIsMalformed(String record) {
        assertThat(reading(record.replace("?", "n".repeat(1_000))).occurrence()).isNotNull();
        assertThatThrownBy(() -> reading(record.replace("?", "n".repeat(1_001))).occurrence())
                .isInstanceOfSatisfying(
                        Refusal.class, refusal -> assertThat(refusal.reason()).isEqualTo(Refusal.Reason.MALFORMED))
                .hasMessageContaining("has 1001 characters, allowed are 1000");
    }

    @Test
    void anyMemberIsReadAsItWasWritten() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        JsonMapper mapper = new JsonMapper();
        for (int round = 0; round < 500; round++) {
            ObjectNode record = mapper.createObjectNode().put("schema", 1);
            int count = random.nextInt(30);
            for (int at = 0; at < count; at++) {
                record.put("text-" + at, "\u00fc\u20ac\"\\ " + random.nextInt())
                        .put("number-" + at, random.nextLong())
                        .put("fraction-" + at, random.nextGaussian())
                        .putNull("null-" + at)
                        .putObject("inner-" + at)
                        .put("number", at);
                record.putArray("list-" + at).add("a").add(record.get("text-" + at));
            }
            JsonRecord read = Reading.of(mapper.writeValueAsBytes(record)).record();
            for (int at = 0; at < count; at++) {
                String text = record.get("text-" + at).stringValue();
                assertThat(read.text("text-" + at)).as("seed %d", seed).isEqualTo(text);
                assertThat(read.number("number-" + at))
                        .isEqualTo(record.get("number-" + at).longValue());
                assertThat(read.fraction("fraction-" + at, 0))
                        .isEqualTo(record.get("fraction-" + at).doubleValue());
                assertThat(read.inner("inner-" + at).orElseThrow().number("number"))
                        .isEqualTo(at);
                assertThat(read.inner("null-" + at)).isEmpty();
                assertThat(read.texts("list-" + at)).isEqualTo(List.of("a", text));
            }
        }
    }

    @Test
    void theLastOfTwoMembersOfANameCounts() {
        assertThat(reading("{\"number\":1,\"number\":2}").record().number("number"))
                .isEqualTo(2);
    }

    @Test
    void aWholeNumberMayBeWrittenWithAFraction() {
        assertThat(reading("{\"n\":5.0}").record().number("n")).isEqualTo(5);
        assertThat(reading("{\"n\":-1e3}").record().number("n")).isEqualTo(-1_000);
    }

    @Test
    void valuesAreTextsNumbersAndTruths() {
        Occurrence heard = reading("{\"atMillis\":1,\"event\":\"e\",\"holding\":[\"g\"],"
                        + "\"values\":{\"text\":\"a\",\"whole\":2,\"part\":0.5,\"true\":true}}")
                .occurrence();
        assertThat(heard.values().byName())
                .isEqualTo(Map.<String, Object>of("text", "a", "whole", 2.0, "part", 0.5, "true", true));
        assertThat(((Occurrence.Heard) heard).holding()).containsExactly("g");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "null",
                "7",
                "[]",
                "{} {}",
                "{\"a\":}",
                "{\"schema\":\"1\"}",
                "{\"schema\":0}",
                "{\"atMillis\":1.5,\"event\":\"e\"}",
                "{\"atMillis\":1e300,\"event\":\"e\"}",
                "{\"atMillis\":99999999999999999999,\"event\":\"e\"}",
                "{\"atMillis\":9223372036855,\"event\":\"e\"}",
                "{\"atMillis\":-9223372036855,\"event\":\"e\"}",
                "{\"atMillis\":null,\"event\":\"e\"}",
                "{\"atMillis\":1,\"event\":7}",
                "{\"atMillis\":1,\"event\":\"e\",\"kind\":null}",
                "{\"atMillis\":1,\"event\":\"e\",\"source\":\"timer\"}",
                "{\"atMillis\":1,\"event\":\"e\",\"deviceActed\":\"yes\"}",
                "{\"atMillis\":1,\"event\":\"e\",\"holding\":\"g\"}",
                "{\"atMillis\":1,\"event\":\"e\",\"holding\":[1]}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":[1]}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":{\"a\":[]}}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":{\"a\":NaN}}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":{\"a\":Infinity}}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":{\"a\":0x1p3}}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":{\"a\":1d}}",
                "{\"atMillis\":1,\"event\":\"e\",\"values\":{\"a\":-1e999}}",
                "{\"atMillis\":1,\"event\":\"e\",\"visit\":\"1\"}"
            })
    void whatCannotBeReadIsMalformed(String record) {
        assertThatThrownBy(() -> reading(record).occurrence())
                .isInstanceOfSatisfying(
                        Refusal.class, refusal -> assertThat(refusal.reason()).isEqualTo(Refusal.Reason.MALFORMED));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"sequence\":1,\"outcome\":\"sent\",\"atMillis\":1,\"state\":\" \"}",
                "{\"sequence\":1,\"outcome\":\"sent\",\"atMillis\":9223372036855}",
                "{\"sequence\":1,\"outcome\":\"perhaps\",\"atMillis\":1}"
            })
    void anAnswerThatCannotBeReadIsMalformed(String record) {
        assertThatThrownBy(() -> reading(record).answer())
                .isInstanceOfSatisfying(
                        Refusal.class, refusal -> assertThat(refusal.reason()).isEqualTo(Refusal.Reason.MALFORMED));
    }

    @Test
    void aCommandWithTooManyValuesIsMalformed() {
        String values =
                IntStream.range(0, 65).mapToObj(each -> "\"" + each + "\":1").collect(Collectors.joining(","));
        assertThatThrownBy(() -> reading(
                                "{\"sequence\":1,\"kind\":\"locate\",\"deadlineMillis\":1,\"values\":{" + values + "}}")
                        .order())
                .isInstanceOf(Refusal.class)
                .hasMessageContaining("at most 64");
    }

    @Test
    void aNumberThatIsTooLargeIsRefusedByName() {
        String remedy = "' is too large; send one of at most 1.7E308, or a string";
        for (String large : List.of("1e999", "-1e999", "9".repeat(400))) {
            assertThatThrownBy(() -> reading("{\"atMillis\":1,\"event\":\"e\",\"values\":{\"level\":" + large + "}}")
                            .occurrence())
                    .hasMessage("the number 'level" + remedy);
            assertThatThrownBy(() -> Rollout.read(
                            "all",
                            ("{\"schema\":1,\"from\":\"a\",\"to\":\"b\",\"percent\":" + large + "}")
                                    .getBytes(StandardCharsets.UTF_8)))
                    .hasMessage("the number 'percent" + remedy);
        }
    }
}
