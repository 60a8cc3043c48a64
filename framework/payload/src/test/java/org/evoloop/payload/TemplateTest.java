package org.evoloop.payload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Map;
import org.evoloop.evolution.Values;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Values in messages to be sent. */
class TemplateTest {
    private static final Values VALUES = new Values(
            Map.of("n", 21.0, "half", -0.5, "big", 1e20, "on", true, "word", "a \"b\" ü\n&{}", "plain", "low"));

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "LEVEL ${n}|LEVEL 21",
                "${half},${big},${on}|-0.5,100000000000000000000,true",
                "{\"level\": ${n}, \"on\": ${on}}|{\"level\": 21, \"on\": true}",
                "{\"mode\": ${plain}}|{\"mode\": \"low\"}",
                "{\"mode\": \"is ${plain}\"}|{\"mode\": \"is low\"}",
                "{\"mode\": \"${word}\"}|{\"mode\": \"a \\\"b\\\" ü\\n&{}\"}",
                "[\"\\\"${plain}\", ${plain}]|[\"\\\"low\", \"low\"]",
                "{not json ${plain}}|{not json low}",
                "costs $5 {n} ${} ${5}|costs $5 {n} ${} ${5}",
            })
    void aValueIsWrittenAsItsPlaceNeeds(String template, String message) {
        assertThat(Template.of(template).with(VALUES)).isEqualTo(message);
    }

    @Test
    void aValueCannotLeaveItsPlaceInAUrl() {
        assertThat(Template.url("http://fan.local/${word}?n=${n}").with(VALUES))
                .isEqualTo("http://fan.local/a%20%22b%22%20%C3%BC%0A%26%7B%7D?n=21");
    }

    @Test
    void aMissingValueIsNamed() {
        Template template = Template.of("set ${degrees}");
        assertThat(template.names()).containsExactly("degrees");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> template.with(Values.NONE))
                .withMessage("the event carries no degrees, which the message needs");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> template.with(Values.of("n", 1)))
                .withMessageContaining("only n=1");
    }
}
