package org.evoloop.fleet.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class JsonTest {
    private static final JsonMapper MAPPER = new JsonMapper();

    @Test
    void membersComeInTheOrderInWhichTheyAreWritten() {
        Json json = new Json().with("b", 1).with("a", "x").begin("in").with("c", true);
        json.end().with("list", List.of("p", "q")).withText("none", "").with("d", -0.5);
        json.beginList("things").element().with("n", 1).end();
        json.element().end().endList();
        assertThat(Wire.text(json.bytes()))
                .isEqualTo("{\"schema\":1,\"b\":1,\"a\":\"x\",\"in\":{\"c\":true},\"list\":[\"p\",\"q\"],\"d\":-0.5,"
                        + "\"things\":[{\"n\":1},{}]}");
    }

    @Test
    void anyTextIsReadAsItWasWritten() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        for (int round = 0; round < 2_000; round++) {
            StringBuilder text = new StringBuilder();
            for (int length = random.nextInt(400); length > 0; length--) {
                int kind = random.nextInt(40);
                text.appendCodePoint(
                        kind == 0
                                ? random.nextInt(0x20)
                                : kind == 1
                                        ? "\"\\/\u00fc\u20ac".codePointAt(random.nextInt(5))
                                        : kind == 2 ? 0x1f600 : 'a');
            }
            JsonNode read = MAPPER.readTree(new Json()
                    .withValues("values", Map.of(text.toString(), text.toString()))
                    .with("after", round)
                    .bytes());
            assertThat(read.get("values").get(text.toString()).stringValue())
                    .as("seed %d", seed)
                    .isEqualTo(text.toString());
            assertThat(read.get("after").longValue()).isEqualTo(round);
        }
    }

    @Test
    void anyNumberIsReadAsItWasWritten() {
        for (long number = 1; number != 0; number *= 2) {
            for (long each : new long[] {number, -number, number - 1, Long.MAX_VALUE, Long.MIN_VALUE}) {
                JsonNode read = MAPPER.readTree(new Json().with("n", each).bytes());
                assertThat(read.get("n").longValue()).isEqualTo(each);
            }
        }
    }

    @Test
    void valuesAreTextsNumbersAndTruths() {
        Map<String, Object> values = new TreeMap<>(Map.of("a", "b", "c", 1.5, "d", false));
        assertThat(Wire.text(new Json().withValues("values", values).bytes()))
                .isEqualTo("{\"schema\":1,\"values\":{\"a\":\"b\",\"c\":1.5,\"d\":false}}");
        assertThat(Wire.text(new Json().withValues("values", Map.of()).bytes())).isEqualTo("{\"schema\":1}");
    }

    @Test
    void aNumberThatJsonLacksIsAText() {
        Map<String, Object> values = new TreeMap<>(Map.of("a", Double.NaN, "b", Double.NEGATIVE_INFINITY));
        JsonNode read = MAPPER.readTree(new Json()
                .withValues("values", values)
                .with("c", Double.POSITIVE_INFINITY)
                .bytes());
        assertThat(read.get("values").get("a").stringValue()).isEqualTo("NaN");
        assertThat(read.get("values").get("b").stringValue()).isEqualTo("-Infinity");
        assertThat(read.get("c").stringValue()).isEqualTo("Infinity");
    }

    @Test
    void halfACharacterIsReadAsItWasWritten() {
        for (String half : List.of("\ud83d", "\ude00", "a\ude00\ud83d\ude00\ud83db")) {
            byte[] bytes = new Json().with("half", half).bytes();
            assertThat(MAPPER.readTree(bytes).get("half").stringValue()).isEqualTo(half);
            assertThat(Reading.of(bytes).text("half")).isEqualTo(half);
        }
    }
}
