package org.evoloop.fleet.wire;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Compared with Jackson. */
class JsonReaderTest {
    private static final String RECORD = """
            { "a":"text","b\\t":"\\u00e9\\\\\\"\\/\\n\u20ac\\ud83d\\ude00", "n":[0,-0,-12.5e-3,1E+2,123456789012345678,
             9223372036854775807,-9223372036854775808,9223372036854775808,0.5],
            "in":{"t":true,"f":false,"none":null,"empty":{},"list":[ ]}, "a":"last" }""";

    private static final String ODDITIES = "{}[]\",:\\ \n\tabfnrtu0123456789+-.eE\u0001";

    private final JsonMapper mapper = new JsonMapper();

    @Test
    void whateverIsChangedInARecordIsReadOrRefusedAsByAnotherReader() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        int read = 0;
        for (int round = 0; round < 50_000; round++) {
            StringBuilder text = new StringBuilder(RECORD);
            for (int changes = random.nextInt(3); changes > 0; changes--) {
                int at = random.nextInt(text.length());
                char odd = ODDITIES.charAt(random.nextInt(ODDITIES.length()));
                switch (random.nextInt(3)) {
                    case 0 -> text.deleteCharAt(at);
                    case 1 -> text.insert(at, odd);
                    default -> text.setCharAt(at, odd);
                }
            }
            byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
            JsonNode expected = expected(bytes);
            if (expected == null) {
                assertThatThrownBy(() -> JsonReader.read(bytes))
                        .as("seed %d: %s", seed, text)
                        .isInstanceOf(Refusal.class);
            } else {
                assertThat(isSame(JsonReader.read(bytes), expected))
                        .as("seed %d: %s", seed, text)
                        .isTrue();
                read++;
            }
        }
        assertThat(read).isGreaterThan(10_000);
    }

    private @Nullable JsonNode expected(byte[] bytes) {
        try {
            return mapper.readTree(bytes);
        } catch (JacksonException e) {
            return null;
        }
    }

    private static boolean isSame(@Nullable Object value, JsonNode expected) {
        if (value instanceof Members members) {
            return expected.isObject()
                    && expected.properties().stream()
                            .allMatch(each -> isSame(members.get(each.getKey()), each.getValue()));
        } else if (value instanceof List<?> list) {
            boolean same = expected.isArray() && expected.size() == list.size();
            for (int at = 0; same && at < list.size(); at++) {
                same = isSame(list.get(at), expected.get(at));
            }
            return same;
        } else if (value instanceof String text) {
            return expected.isString() && expected.stringValue().equals(text);
        } else if (value instanceof Long number) {
            return expected.canConvertToLong() && expected.longValue() == number;
        } else if (value instanceof Double number) {
            return expected.isNumber() && expected.doubleValue() == number;
        } else if (value instanceof Boolean truth) {
            return expected.isBoolean() && expected.booleanValue() == truth;
        }
        return value == Members.NULL && expected.isNull();
    }

    @Test
    void textsThatAreNotUtf8AreRefused() {
        byte[] bytes = "{\"a\":\"\u00e9\"}".getBytes(StandardCharsets.ISO_8859_1);
        assertThatThrownBy(() -> JsonReader.read(bytes)).isInstanceOf(Refusal.class);
    }

    @Test
    void nestingIsLimited() {
        String deep = "[".repeat(100) + "]".repeat(100);
        assertThat(JsonReader.read(deep.getBytes(StandardCharsets.UTF_8))).isInstanceOf(List.class);
        byte[] deeper = ("[" + deep + "]").getBytes(StandardCharsets.UTF_8);
        assertThatThrownBy(() -> JsonReader.read(deeper))
                .isInstanceOf(Refusal.class)
                .hasMessageContaining("nested");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "", " ", "1 2", "\"a", "\"\\", "\"\\u12", "tru", "nul", "-", "1.", "1e", "{\"a\"", "[1", "\u0000",
                "1\u0000"
            })
    void whatDoesNotEndOrIsNoValueIsRefused(String text) {
        assertThatThrownBy(() -> JsonReader.read(text.getBytes(StandardCharsets.UTF_8)))
                .isInstanceOf(Refusal.class);
    }
}
