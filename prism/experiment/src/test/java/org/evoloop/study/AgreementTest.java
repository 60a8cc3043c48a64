package org.evoloop.study;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class AgreementTest {
    private final Agreement agreement = new Agreement();

    @Test
    void countsHowLongTheRecordWasWrong() {
        agreement.note(true, 5);
        assertThat(agreement.divergedNanos()).isNegative();
        agreement.note(false, 10);
        agreement.note(false, 15);
        agreement.note(true, 20);
        agreement.note(false, 30);

        assertThat(agreement.divergedNanos()).isEqualTo(10);
        assertThat(agreement.wrongNanos(0, 10)).isZero();
        assertThat(agreement.wrongNanos(0, 40)).isEqualTo(20);
        assertThat(agreement.wrongNanos(12, 18)).isEqualTo(6);
        assertThat(agreement.wrongNanos(15, 25)).isEqualTo(5);
        assertThat(agreement.wrongNanos(20, 30)).isZero();
        assertThat(agreement.wrongNanos(35, 50)).isEqualTo(15);
    }
}
