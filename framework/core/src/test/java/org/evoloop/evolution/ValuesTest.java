package org.evoloop.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ValuesTest {
    private static Map<String, Object> numbers(int count) {
        return IntStream.range(0, count).boxed().collect(Collectors.toMap(number -> "n" + number, number -> number));
    }

    @Test
    void anEventCarriesSoManyValuesAndNoMore() {
        Values most = new Values(numbers(Values.MOST));

        assertThat(most.byName()).hasSize(Values.MOST);
        assertThatThrownBy(() -> most.with("more", 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("65 values; at most 64");
    }

    @Test
    void namesAndTextsHaveSoManyCharactersAndNoMore() {
        String text = "x".repeat(Values.MOST_CHARACTERS - 1);

        assertThat(Values.of("t", text).text("t")).isEqualTo(text);
        assertThatThrownBy(() -> Values.of("t", text + "x"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("at most 16384");
        assertThatThrownBy(() -> Values.of(text + "xx", 1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    @SuppressWarnings("NullAway")
    void nullIsNoValue() {
        assertThatThrownBy(() -> Values.of("t", null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the value t is null; allowed are texts, numbers and true or false");
    }
}
