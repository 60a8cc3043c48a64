package org.evoloop.payload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.evoloop.function.Reading;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JsonTest {
    @Test
    void membersComeInTheOrderInWhichTheyWerePut() {
        JsonObject json = new JsonObject()
                .put("b", 1)
                .put("a", "x")
                .put("in", new JsonObject().put("c", true))
                .putTexts("list", List.of("p", "q"))
                .putSome("none", "")
                .putSome("no values", Map.of())
                .put("d", -0.5)
                .put("null", (String) null)
                .put("things", List.of(new JsonObject().put("n", 1), new JsonObject()));
        assertThat(json)
                .hasToString("{\"b\":1,\"a\":\"x\",\"in\":{\"c\":true},\"list\":[\"p\",\"q\"],\"d\":-0.5,"
                        + "\"null\":null,\"things\":[{\"n\":1},{}]}");
        assertThat(JsonRecord.of(json.toString()).copy().put("b", 2).toString())
                .isEqualTo(json.toString().replaceFirst("1", "2"));
        assertThat(JsonObject.of(List.of(Reading.of("up", true), Reading.of("state", "on"))))
                .hasToString("{\"up\":true,\"state\":\"on\"}");
    }

    @Test
    void anyTextIsReadAsItWasWritten() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        for (int round = 0; round < 2_000; round++) {
            StringBuilder any = new StringBuilder();
            for (int length = random.nextInt(400); length > 0; length--) {
                // Half of a character may be alone, except in a name.
                any.append(random.nextInt(4) == 0 ? (char) random.nextInt(1 << 16) : 'a');
            }
            String text = any.toString();
            String name = text.replaceAll("[\\ud800-\\udfff]", "\ud83d\ude00");
            byte[] written = new JsonObject()
                    .putSome("values", Map.of(name, text))
                    .put("after", round)
                    .toBytes();
            JsonRecord read = JsonRecord.of(written, IllegalStateException::new);
            assertThat(read.inner("values").orElseThrow().text(name))
                    .as("seed %d", seed)
                    .isEqualTo(text);
            assertThat(read.number("after")).isEqualTo(round);
        }
    }

    @Test
    void anyNumberIsReadAsItWasWritten() {
        for (long number = 1; number != 0; number *= 2) {
            for (long each : new long[] {number, -number, number - 1, Long.MAX_VALUE, Long.MIN_VALUE}) {
                JsonRecord read = JsonRecord.of(
                        new JsonObject().put("n", each).put("d", each / 3.0).toString());
                assertThat(read.number("n")).isEqualTo(each);
                assertThat(read.fraction("d", 0)).isEqualTo(each / 3.0);
            }
        }
    }

    @Test
    void aNumberThatJsonLacksIsAText() {
        Map<String, Object> values = new TreeMap<>(Map.of("a", Double.NaN, "b", Double.NEGATIVE_INFINITY, "c", 1.5));
        assertThat(new JsonObject().putSome("values", values).put("d", Double.POSITIVE_INFINITY))
                .hasToString("{\"values\":{\"a\":\"NaN\",\"b\":\"-Infinity\",\"c\":1.5},\"d\":\"Infinity\"}");
    }

    @Test
    void aConstantIsAWord() {
        assertThat(JsonObject.word(Thread.State.TIMED_WAITING)).isEqualTo("timed-waiting");
    }

    @Test
    void nestingIsLimited() {
        String deep = "{\"a\":" + "[".repeat(99) + "]".repeat(99) + "}";
        assertThat(JsonRecord.of(deep).has("a")).isTrue();
        assertThatThrownBy(() -> JsonRecord.of("{\"b\":" + deep + "}")).hasMessageContaining("more than 100 lists");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                " ",
                "1",
                "[]",
                "null",
                "{",
                "{} {}",
                "{}]",
                "{\"a",
                "{\"a\":\"\\",
                "{\"a\":\"\\u12\"}",
                "{\"a\":tru}",
                "{\"a\":-}",
                "{\"a\":1.}",
                "{\"a\":1e}",
                "{\"a\":01}",
                "{\"a\":+1}",
                "{\"a\":NaN}",
                "{\"a\":0x1}",
                "{\"a\"}",
                "{\"a\":[1}",
                "{a:1}",
                "{'a':1}",
                "{\"a\":1,}",
                "{\"a\":[1,]}",
                "{\"a\":\"\n\"}",
                "{}\u0000",
                "//\n{}",
                "\ufeff{}"
            })
    void whatIsNoObjectIsRefusedAsTextAndAsBytes(String text) {
        assertThatThrownBy(() -> JsonRecord.of(text)).isInstanceOf(IllegalArgumentException.class);
        for (var charset : List.of(StandardCharsets.UTF_8, StandardCharsets.UTF_16LE)) {
            assertThatThrownBy(() -> JsonRecord.of(text.getBytes(charset), ModelException::new))
                    .isInstanceOf(ModelException.class);
        }
    }

    @Test
    void bytesAreUtf8() {
        for (var charset : List.of(StandardCharsets.ISO_8859_1, StandardCharsets.UTF_16, StandardCharsets.UTF_16BE)) {
            assertThatThrownBy(
                            () -> JsonRecord.of("{\"a\":\"\u00e9\"}".getBytes(charset), IllegalArgumentException::new))
                    .as("%s", charset)
                    .isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void aMistakeIsNamed() {
        JsonRecord record = JsonRecord.of("{\"n\":1.5,\"null\":null,\"list\":[1],\"values\":{\"a\":[]}}");
        assertThatThrownBy(() -> record.number("n")).hasMessage("'n' must be a whole number");
        assertThatThrownBy(() -> record.number("none")).hasMessage("'none' must be a whole number");
        assertThatThrownBy(() -> record.number("null", 1)).hasMessage("'null' must be a whole number");
        assertThatThrownBy(() -> record.fraction("list", 1)).hasMessage("'list' must be a number");
        assertThatThrownBy(() -> record.text("null", "")).hasMessage("'null' must be a string");
        assertThatThrownBy(() -> record.truth("n")).hasMessage("'n' must be true or false");
        assertThatThrownBy(() -> record.texts("n")).hasMessage("'n' must be a list");
        assertThatThrownBy(() -> record.texts("list")).hasMessage("'list' must be a list of strings");
        assertThatThrownBy(() -> record.each("list")).hasMessage("'list' must be a list of objects");
        assertThatThrownBy(() -> record.inner("list")).hasMessage("'list' must be an object");
        assertThatThrownBy(() -> record.values("values")).hasMessageContaining("the value a is");
        assertThat(record.inner("null")).isEmpty();
        assertThat(record.texts("null")).isEmpty();
        assertThatThrownBy(() -> JsonRecord.of("{\"a\":\n tru}"))
                .hasMessageStartingWith("it is not valid JSON: line 2, column ");
    }

    @Test
    void aNumberThatIsTooLargeIsRefusedByName() {
        for (String large : List.of("1e999", "-1e999", "[" + "9".repeat(400) + "]")) {
            assertThatThrownBy(() -> JsonRecord.of("{\"in\":{\"level\":" + large + "}}"))
                    .hasMessage("the number 'level' is too large; send one of at most 1.7E308, or a string");
        }
    }
}
