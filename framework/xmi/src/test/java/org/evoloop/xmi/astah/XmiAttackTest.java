package org.evoloop.xmi.astah;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.LongFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Documents of 1 GiB that are refused within their first few MiB. */
class XmiAttackTest {

    @Test
    void shouldRefuseDeepNesting() {
        for (String beginning : List.of(Attack.HEAD, Attack.MACHINE)) {
            assertThat(Attack.answer(beginning, "<UML:StateMachine.top xmlns:UML='org.omg.xmi.namespace.UML'>"))
                    .startsWith("F.xml: nests elements deeper than 500");
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "<a b='",
                "<!--",
                "<![CDATA[",
                "<?a ",
                "<a ",
            })
    void shouldRefuseAnEndlessToken(String token) {
        for (String beginning : List.of(Attack.HEAD, Attack.TRANSITIONS)) {
            assertThat(Attack.answer(beginning + token, "               "))
                    .startsWith("F.xml: holds a single tag, text or comment of more than 4 MiB (line ");
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "<?xml version='1.0' ", "<!DOCTYPE a ", "<!DOCTYPE a [", "<XMI><XMI.header><XMI.exporter>"})
    void shouldRefuseAnEndlessHead(String beginning) {
        assertThat(Attack.answer(beginning, "          "))
                .startsWith("F.xml: holds a single tag, text or comment of more than 4 MiB");
    }

    @Test
    void shouldRefuseAnEndlessName() {
        assertThat(Attack.answer(Attack.HEAD + "<", "aaaa")).startsWith("F.xml: is damaged or not XML, ");
    }

    @Test
    void shouldRefuseEndlesslyManyAttributes() {
        assertThat(Attack.answer(Attack.HEAD + "<a", index -> " b" + index + "='1'"))
                .startsWith("F.xml: is damaged or not XML, ");
    }

    @Test
    void shouldRefuseEndlesslyManyNamesWhichTheParserWouldKeep() {
        assertTooManyNames(index -> "<a" + index + "/>");
        assertTooManyNames(index -> "<a b" + index + "='1'/>");
        assertTooManyNames(index -> "<a xmlns='u" + index + "'/>");
        assertTooManyNames(index -> "<p" + index + ":a xmlns:p" + index + "='u'/>");
        assertTooManyNames(index -> "<?a" + index + "?>");
    }

    private static void assertTooManyNames(LongFunction<String> units) {
        assertThat(Attack.answer(Attack.HEAD, units)).startsWith("F.xml: uses more than 10000 different names");
    }

    @Test
    void shouldReadAMachineOfTenThousandTransitions() {
        assertThat(LargeMachine.read(10_000).transitions()).hasSize(10_000);
    }
}
