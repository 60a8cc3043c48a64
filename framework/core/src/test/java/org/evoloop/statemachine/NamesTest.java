package org.evoloop.statemachine;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class NamesTest {
    @Test
    void inOneLineThereIsNoLineBreakAndNothingThatChangesATerminal() {
        assertThat(Names.inOneLine("a\nb\r\nc\u0085d\u2028e\u2029f\u0000g\u001b[2J\u007f"))
                .isEqualTo("a?b??c?d?e?f?g?[2J?");
    }

    @Test
    void inOneLineAllElseStaysAsItIs() {
        String plain = "On\tand off: 開始 é \uD83E\uDD16";

        assertThat(Names.inOneLine(plain)).isSameAs(plain);
    }

    @Test
    void aNameInAMessageIsInOneLine() {
        assertThat(Names.shown("a\nb\u2028c")).isEqualTo("a?b?c");
    }
}
